#include "player/window/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>
#include <utility>

#include "gl/context.h"
#include "player/interface/panels.h"
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
        if (button != GLFW_MOUSE_BUTTON_LEFT || action != GLFW_PRESS) return;
        const Click click{glfwGetTime(), in.x_, in.y_};
        const Click last = std::exchange(in.clicked_, click);
        if (click.at - last.at > most_seconds || std::hypot(click.x - last.x, click.y - last.y) > most_pixels)
            return;
        e.input.double_clicked = true;
        in.clicked_ = {};  // a third click begins anew
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
    set_style();
    watch_events();  // first: ImGui calls the callbacks that it finds
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 450");
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
