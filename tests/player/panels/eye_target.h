#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/gl/context.h"
#include "player/panels/eye_picture.h"

namespace vantage {

/// An offscreen picture on which panels and marks are drawn, in floats, so that nothing is rounded. The eye
/// is at the origin and looks along z.
class EyeTarget {
  public:
    EyeTarget(int width, int height, double pixels_per_degree = 20)
        : color_(gl::make_texture_2d("picture", GL_RGBA32F, width, height)),
          target_(gl::make_framebuffer("picture", std::array{color_.id()}, 0)) {
        const double f = pixels_per_degree * 180 / std::numbers::pi;
        eye.view.intrinsics = {width, height, f, f, width / 2.0, height / 2.0};
        eye.nearest = 0.01;
        eye.target = target_.id();
        fill({0, 0, 0, 1});
    }

    void fill(const std::array<float, 4>& color) {
        glClearNamedFramebufferfv(target_.id(), GL_COLOR, 0, color.data());
    }
    /// Reads the first channel of the target.
    std::vector<float> values() const {
        const FrameSize size = frame_size(eye.view);
        std::vector<float> out(std::size_t(size.width) * std::size_t(size.height));
        glGetTextureImage(color_.id(), 0, GL_RED, GL_FLOAT, GLsizei(out.size() * sizeof(float)), out.data());
        return out;
    }
    std::array<float, 4> at(int x, int y) const {
        std::array<float, 4> out;
        glGetTextureSubImage(color_.id(), 0, x, y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof out, out.data());
        return out;
    }
    /// The viewing direction through the center of a pixel.
    Eigen::Vector3d direction(int x, int y) const {
        const Intrinsics& k = eye.view.intrinsics;
        return {(x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1};
    }

    EyePicture eye;

  private:
    gl::Texture color_;
    gl::Framebuffer target_;
};

}  // namespace vantage
