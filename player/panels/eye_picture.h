#pragma once
#include <Eigen/Core>

#include "base/gl/program.h"
#include "player/view/view.h"

namespace vantage {

/// Depth of the model at each pixel of a picture, for occluding overlays in the scene.
struct ModelDepth {
    GLuint texture = 0;                               ///< depths, top row first; 0: nothing is occluded
    Eigen::Vector2d terms = Eigen::Vector2d::Zero();  ///< a and b: depth is a + b / z, with z in scene units
    FrameSize frame{};  ///< size of the used part of the texture, which starts at the first texel
};

/// A finished picture for one eye, on which overlays are drawn: sRGB, 8 bits. Overlays behind the model are
/// drawn with share_behind of their opacity, so that they remain visible.
struct EyePicture {
    View view;          ///< perspective; its frame has the size of the target
    double nearest;     ///< near limit of overlays: scene units, above 0
    GLuint target;      ///< framebuffer
    bool flip = false;  ///< the target's first row is at the bottom, as in a window
    ModelDepth depth{};
};

/// Clip-from-origin matrix for overlays, with the target's row order and no far limit.
Eigen::Matrix4d clip_from_origin(const EyePicture& eye);

/// Enables blending over the picture, makes a program current and sets its uniforms. The program must include
/// hidden.glsl.
void begin_over_picture(const gl::Program& program, const EyePicture& eye);

/// Restores the blending state that other passes expect.
void end_over_picture();

}  // namespace vantage
