#include "player/headset/mirror.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace vantage {
namespace {

constexpr double seconds_between = 1.0 / 30;  ///< minimum interval, to avoid slowing down the headset

FrameSize window_size(const ShowOptions& o) {
    return o.output.size.empty() ? FrameSize{640, 720} : parse_size(o.output.size);
}

}  // namespace

Mirror::Mirror(const ShowOptions& o) {
    const char* display = std::getenv("DISPLAY");
    if (display == nullptr || *display == 0) {
        context_.emplace();
        return;
    }
    window_.emplace(window_size(o), "Vantage", gl::debug_from_environment() == gl::Debug::on);
    glfwSwapInterval(0);  // the headset determines the frame rate
}

void Mirror::show(GLuint framebuffer, FrameSize size) {
    if (!window_ || glfwGetTime() < shown_at_ + seconds_between) return;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_->get(), &width, &height);
    if (width < 1 || height < 1) return;  // minimized
    const double scale = std::min(double(width) / size.width, double(height) / size.height);
    const int w = std::max(1, int(size.width * scale)), h = std::max(1, int(size.height * scale));
    const int left = (width - w) / 2, bottom = (height - h) / 2;
    const std::array<float, 4> black{0, 0, 0, 1};
    glClearNamedFramebufferfv(0, GL_COLOR, 0, black.data());
    glBlitNamedFramebuffer(framebuffer, 0, 0, 0, size.width, size.height, left, bottom, left + w, bottom + h,
                           GL_COLOR_BUFFER_BIT, GL_LINEAR);
    copied_ = true;
}

void Mirror::attend() {
    if (!window_) return;
    window_->events();
    if (!std::exchange(copied_, false)) return;
    glfwSwapBuffers(window_->get());
    shown_at_ = glfwGetTime();
}

MirrorButtons Mirror::buttons() const {
    if (!window_) return {};
    GLFWwindow* const w = window_->get();
    const auto down = [&](int key, int button) {
        return glfwGetKey(w, key) == GLFW_PRESS || glfwGetMouseButton(w, button) == GLFW_PRESS;
    };
    return {down(GLFW_KEY_SPACE, GLFW_MOUSE_BUTTON_LEFT), down(GLFW_KEY_M, GLFW_MOUSE_BUTTON_RIGHT)};
}

bool Mirror::closed() const { return window_ && glfwWindowShouldClose(window_->get()); }

}  // namespace vantage
