#pragma once
#include <cstdint>
#include <vector>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "player/render/passes/frame_targets.h"

namespace vantage {

/// Gives pixels that no photo shows the colors around them, by a pyramid of means that is averaged downward
/// and filled in upward (after the pull-push of Gortler et al. 1996). Holes count with their own color, too,
/// but so little that it shows only far from all others. For holes of the background, the mesh's colors
/// count little: they are of something nearer.
class HoleFilling {
  public:
    HoleFilling();

    /// For frames of at most this size.
    void fit(int width, int height);
    static std::uint64_t bytes(int width, int height);
    /// The weight of a hole's own color: it counts as much as what surrounds it at an eighth of the frame.
    static float hole_weight(int width, int height);

    /// Fills the pyramids from the samples accumulated for a frame of this size, `samples` per pixel.
    /// `surface`: as in SurfaceTargets::shaded.
    void fill(const gl::Texture& accumulated, GLuint surface, const FrameTargets& targets, double samples);
    /// Square roots of light at half the frame's size, without holes; from the texture's first texel.
    const gl::Texture& filled() const { return levels_.front().whole; }
    /// The same for holes of the background.
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
