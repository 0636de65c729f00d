#pragma once
#include <cstdint>
#include <vector>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "player/render/passes/frame_targets.h"

namespace vantage {

/// Gives pixels that no photo shows the colors around them, by a pyramid of means that is averaged downward
/// and filled in upward (after the pull-push of Gortler et al. 1996). Holes count with their own color, too,
/// but so little that it shows only far from all others.
class HoleFilling {
  public:
    HoleFilling();

    /// For frames of at most this size.
    void fit(int width, int height);
    static std::uint64_t bytes(int width, int height);
    /// The weight of a hole's own color: it counts as much as what surrounds it at an eighth of the frame.
    static float hole_weight(int width, int height);

    /// Fills the pyramid from the samples accumulated for a frame of this size, `samples` per pixel.
    void fill(const gl::Texture& accumulated, int width, int height, double samples);
    /// Square roots of light at half the frame's size, without holes; from the texture's first texel.
    const gl::Texture& filled() const { return levels_.front().texture; }

  private:
    struct Level {
        gl::Texture texture;
        gl::Framebuffer target;
    };
    std::vector<Level> levels_;
    gl::Program average_program_, fill_program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
