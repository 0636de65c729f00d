#include "player/window/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gl/context.h"
#include "player/interface/style.h"
#include "scene/error.h"

namespace vantage {
namespace {

[[noreturn]] void fail() {
    const char* why = nullptr;
    glfwGetError(&why);
    const std::string text = why ? why : "unknown reason";
    glfwTerminate();
    throw Error(Exit::graphics,
                "no window with OpenGL 4.5: " + text + " (--offscreen renders without a display)");
}

}  // namespace

struct GlfwWindow::Callbacks {
    static GlfwWindow& window(GLFWwindow* w) {
        return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(w));
    }
    static WindowEvents& events(GLFWwindow* w) {
        window(w).events_.any = true;
        return window(w).events_;
    }
    static void key(GLFWwindow* w, int key, int, int action, int modifiers) {
        using With = KeyPress::With;
        WindowEvents& e = events(w);
        if (action == GLFW_RELEASE) return;
        const int with = modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER);
        e.input.keys.push_back({key,
                                with == 0                  ? With::nothing
                                : with == GLFW_MOD_CONTROL ? With::control
                                                           : With::other,
                                action == GLFW_REPEAT});
    }
    static void drop(GLFWwindow* w, int count, const char** files) {
        std::vector<std::string>& dropped = events(w).dropped;
        dropped.insert(dropped.end(), files, files + count);
    }
    /// Double clicks are found here: where a frame is longer than two clicks, ImGui sees one.
    static void button(GLFWwindow* w, int button, int action, int) {
        constexpr double most_seconds = 0.4, most_pixels = 5;
        WindowEvents& e = events(w);
        GlfwWindow& in = window(w);
        if (button < int(in.down_.size())) in.down_[std::size_t(button)] = action == GLFW_PRESS;
        if (button != GLFW_MOUSE_BUTTON_LEFT) return;
        LastPress& last = in.pressed_;
        const bool in_place = std::hypot(in.x_ - last.x, in.y_ - last.y) <= most_pixels;
        if (action == GLFW_RELEASE) {
            if (in_place) e.input.clicks.push_back({last.x, last.y, last.second});
            return;
        }
        const double now = glfwGetTime();
        const bool second =
            in_place && !last.second && now - last.at <= most_seconds;  // a third click begins anew
        e.input.double_clicked |= second;
        last = {now, in.x_, in.y_, second};
    }
    /// The motion while a button was down: ImGui only knows whether it is down when a frame begins.
    static void cursor(GLFWwindow* w, double x, double y) {
        WindowEvents& e = events(w);
        GlfwWindow& in = window(w);
        for (std::size_t b = 0; b < in.down_.size(); ++b)
            if (in.down_[b]) e.input.drags[b].right += x - in.x_, e.input.drags[b].down += y - in.y_;
        in.x_ = x;
        in.y_ = y;
    }
};

GlfwWindow::GlfwWindow(FrameSize size, const std::string& title, bool debug) {
    if (!glfwInit()) fail();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug ? GLFW_TRUE : GLFW_FALSE);
    window_ = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (!window_) fail();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    if (debug) gl::watch_errors();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    set_style(text_scale_);
    watch_events();  // first: ImGui calls the callbacks that it finds
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 450");
}

namespace {

/// The monitor that shows the middle of the window.
GLFWmonitor* monitor_of(GLFWwindow* window) {
    int x = 0, y = 0, width = 0, height = 0, count = 0;
    glfwGetWindowPos(window, &x, &y);
    glfwGetWindowSize(window, &width, &height);
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        int left = 0, top = 0;
        glfwGetMonitorPos(monitors[i], &left, &top);
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        const int right = x + width / 2 - left, down = y + height / 2 - top;
        if (mode && right >= 0 && down >= 0 && right < mode->width && down < mode->height) return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

}  // namespace

void GlfwWindow::fill_screen(bool whole) {
    if (whole == windowed_.has_value()) return;
    if (!whole) {
        const Place p = *std::exchange(windowed_, std::nullopt);
        return glfwSetWindowMonitor(window_, nullptr, p.x, p.y, p.width, p.height, GLFW_DONT_CARE);
    }
    GLFWmonitor* monitor = monitor_of(window_);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    Place& p = windowed_.emplace();
    glfwGetWindowPos(window_, &p.x, &p.y);
    glfwGetWindowSize(window_, &p.width, &p.height);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

float GlfwWindow::fitting_text_scale() const {
    constexpr float pixels_for_plain_text = 1440;  // height of a screen
    float scale = 1, down = 1;
    glfwGetWindowContentScale(window_, &scale, &down);
    GLFWmonitor* monitor = monitor_of(window_);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode) scale = std::max(scale, float(mode->height) / pixels_for_plain_text);
    return std::clamp(scale, 1.0f, most_text_scale);
}

void GlfwWindow::set_text_scale(float scale) {
    if (scale == text_scale_) return;
    text_scale_ = scale;
    set_style(scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void GlfwWindow::watch_events() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, Callbacks::key);
    glfwSetDropCallback(window_, Callbacks::drop);
    glfwSetMouseButtonCallback(window_, Callbacks::button);
    glfwGetCursorPos(window_, &x_, &y_);
    glfwSetCursorPosCallback(window_, Callbacks::cursor);
    constexpr auto note = [](GLFWwindow* w, auto...) { Callbacks::events(w); };
    glfwSetCharCallback(window_, note);
    glfwSetCursorEnterCallback(window_, note);
    glfwSetScrollCallback(window_, note);
    glfwSetWindowFocusCallback(window_, note);
    glfwSetWindowRefreshCallback(window_, note);
    glfwSetWindowIconifyCallback(window_, note);
    glfwSetFramebufferSizeCallback(window_, note);
    glfwSetWindowCloseCallback(window_, note);
}

WindowEvents GlfwWindow::events(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    return std::exchange(events_, {});
}

GlfwWindow::~GlfwWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

}  // namespace vantage
