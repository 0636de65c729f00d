#pragma once
#include <cstdint>
#include <vector>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "player/render/passes/frame_targets.h"

namespace vantage {

/// Gives surrounding colors to pixels that no photo covers, using a pyramid of means that is averaged
/// downward and filled in upward (after the pull-push algorithm of Gortler et al. 1996). Holes contribute
/// their own color with a low weight, so that this color is visible only far from all others. For holes in
/// the background, the mesh's colors have a low weight, since they belong to nearer surfaces.
class HoleFilling {
  public:
    HoleFilling();

    /// Allocates textures for frames of at most this size.
    void fit(int width, int height);
    static std::uint64_t bytes(int width, int height);
    /// The weight of a hole's own color. At a distance of an eighth of the frame's size, surrounding pixels
    /// have the same weight.
    static float hole_weight(int width, int height);

    /// Computes the pyramids from the samples accumulated for a frame of this size, `samples` per pixel.
    /// `surface`: as in SurfaceTargets::shaded.
    void fill(const gl::Texture& accumulated, GLuint surface, const FrameTargets& targets, double samples);
    /// Square roots of light at half the frame's size, without holes, starting at the texture's first texel.
    const gl::Texture& filled() const { return levels_.front().whole; }
    /// Like filled(), for holes in the background.
    const gl::Texture& filled_behind() const { return levels_.front().behind; }

  private:
    struct Level {
        gl::Texture whole, behind;
        gl::Framebuffer target;
    };
    std::vector<Level> levels_;
    gl::Program average_program_, fill_program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
