#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "base/gl/object.h"
#include "player/render/passes/picture_samples.h"
#include "player/view/frame_size.h"

namespace vantage {

/// The bare surface of a frame, with its depth and triangle numbers (from 1).
struct SurfaceTargets {
    gl::Texture depth, shaded, triangles;
    gl::Framebuffer target;
};

/// The render targets of a frame: the bare surface, the picture of photos that are being replaced, two float
/// targets of sums (best photo and transient masking read one and write the other), and the samples of each
/// eye's picture. They may have been allocated for larger frames.
struct FrameTargets {
    int width = 0, height = 0;  ///< frame size in pixels; up to `allocated`
    FrameSize allocated;        ///< size of the largest frame
    int fine = 1;               ///< samples per side of a pixel; each has a texel in surfaces and sums
    SurfaceTargets layers;      ///< surfaces of both eyes, if each has its own
    std::vector<SurfaceTargets> surfaces;  ///< one per eye, from `layers`; or one that the eyes use in turn
    std::size_t surface_number = 0;        ///< index of the last painted eye's surface
    gl::Texture sums[2], before;           ///< all but the first are allocated on demand
    std::vector<std::array<gl::Framebuffer, 2>> sums_targets;  ///< one per surface, which provides the depth
    gl::Framebuffer before_target;
    gl::Texture shadows;  ///< depths from the light, square; allocated on demand
    gl::Framebuffer shadows_target;
    std::vector<PictureSamples> samples;  ///< per eye
    /// The coefficients a and b of the last painted eye's depth values, a + b / z. Not for orthographic
    /// views.
    Eigen::Vector2d depth_terms = Eigen::Vector2d::Zero();

    FrameSize size() const { return {width, height}; }
    FrameSize fine_size() const { return {width * fine, height * fine}; }
    /// Allocate optional targets.
    void add_second_sums();
    void add_before();
    void add_shadows();
    /// Side of `shadows`, and of the part that a frame of the current size uses, texels.
    int shadow_side() const;
    int used_shadow_side() const;
    /// The surface of the last painted eye. The targets must exist.
    const SurfaceTargets& surface() const { return surfaces[surface_number]; }
    const gl::Framebuffer& sums_target(int sums) const {
        return sums_targets[surface_number][std::size_t(sums)];
    }
    static std::uint64_t bytes(FrameSize allocated, std::size_t eyes = 1, std::size_t surfaces = 1,
                               int fine = 1);
};

/// Binds a framebuffer and sets the viewport for a frame of this size.
void bind_target(GLuint framebuffer, FrameSize size);

/// During its lifetime, nothing is cleared or drawn outside the frame, although the targets may be much
/// larger.
class DrawnRegion {
  public:
    explicit DrawnRegion(const FrameTargets& targets) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, targets.fine_size().width, targets.fine_size().height);
    }
    ~DrawnRegion() { glDisable(GL_SCISSOR_TEST); }
    DrawnRegion(const DrawnRegion&) = delete;
    DrawnRegion& operator=(const DrawnRegion&) = delete;
};

/// The triangle at each pixel's last sample in the last frame, row by row from the top, numbered from 1; 0
/// means none. Waits for the graphics card.
std::vector<std::uint32_t> read_triangles(const FrameTargets& targets);

/// Targets for frames of at most this size, for one or two eyes, with one surface per eye or a shared one,
/// and with `fine` * `fine` samples per pixel at once. Throws Error(usage) if the graphics card cannot draw a
/// frame of this size.
FrameTargets make_frame_targets(FrameSize allocated, std::size_t eyes = 1, std::size_t surfaces = 1,
                                int fine = 1);

}  // namespace vantage
