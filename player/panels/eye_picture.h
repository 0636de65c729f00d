#pragma once
#include <Eigen/Core>

#include "base/gl/program.h"
#include "player/view/view.h"

namespace vantage {

/// How far away the model is at each pixel of a picture, for what is drawn in the scene beside it.
struct ModelDepth {
    GLuint texture = 0;  ///< depths, the picture's top row first; 0: nothing is hidden
    Eigen::Vector2d terms =
        Eigen::Vector2d::Zero();  ///< a and b: depth is a + b / z, with z in the scene's unit
    FrameSize frame{};            ///< the part of the texture that is used, from its first texel; pixels
};

/// A finished picture of what an eye sees, to be drawn over: sRGB, 8 bits. What is behind the model is drawn
/// with share_behind of its opacity, so that it is never lost.
struct EyePicture {
    View view;          ///< in perspective; its frame has the size of the target
    double nearest;     ///< nothing nearer than this is drawn: scene units, above 0
    GLuint target;      ///< framebuffer
    bool flip = false;  ///< the target's first row is at the bottom, as a window's is
    ModelDepth depth{};
};

/// Clip-from-origin matrix of what is drawn over the picture, its rows as the target's. Nothing is too far
/// away for it.
Eigen::Matrix4d clip_from_origin(const EyePicture& eye);

/// Makes a program current that blends over the picture and includes hidden.glsl, whose uniforms it sets.
void begin_over_picture(const gl::Program& program, const EyePicture& eye);

/// Leaves blending as other passes expect it.
void end_over_picture();

}  // namespace vantage
