#include "player/window/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/translation.h"
#include "player/interface/keyboard_navigation.h"
#include "player/interface/keys.h"
#include "player/interface/style.h"
#include "player/window/new_frame.h"

namespace vantage {
namespace {

static_assert(key::escape == GLFW_KEY_ESCAPE && key::enter == GLFW_KEY_ENTER &&
              key::backspace == GLFW_KEY_BACKSPACE && key::down == GLFW_KEY_DOWN && key::up == GLFW_KEY_UP &&
              key::keypad_enter == GLFW_KEY_KP_ENTER);

[[noreturn]] void fail() {
    const char* why = nullptr;
    glfwGetError(&why);
    const std::string text = why ? why : "unknown reason";
    glfwTerminate();
    throw Error(Exit::graphics, "cannot open a window with OpenGL 4.5: " + text +
                                    " ('vantage-player render' needs no display)");
}

}  // namespace

struct GlfwWindow::Callbacks {
    static WindowInput& input(GLFWwindow* w) {
        return static_cast<GlfwWindow*>(glfwGetWindowUserPointer(w))->input_;
    }
    /// Letters are identified according to the keyboard layout, and other keys by their position.
    static int key_of(int place, int scancode) {
        const char* name = glfwGetKeyName(place, scancode);
        const bool letter = name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0;
        return letter ? GLFW_KEY_A + (name[0] - 'a') : place;
    }
    static void key(GLFWwindow* w, int key, int scancode, int action, int modifiers) {
        using With = KeyPress::With;
        const int with = modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER);
        input(w).key({key_of(key, scancode), key,
                      with == 0                  ? With::nothing
                      : with == GLFW_MOD_CONTROL ? With::control
                                                 : With::other,
                      action == GLFW_REPEAT, (modifiers & GLFW_MOD_SHIFT) != 0},
                     action != GLFW_RELEASE);
    }
    static void drop(GLFWwindow* w, int count, const char** files) { input(w).drop({files, files + count}); }
    /// Switches from touch to the mouse.
    static void show_cursor(GLFWwindow* w) { glfwSetInputMode(w, GLFW_CURSOR, GLFW_CURSOR_NORMAL); }
    static void button(GLFWwindow* w, int button, int action, int) {
        show_cursor(w);
        input(w).button(std::size_t(button), action == GLFW_PRESS, glfwGetTime());
    }
    static void wheel(GLFWwindow* w, double, double) {
        input(w).note();
        point_before_wheel(w);
    }
    static void cursor(GLFWwindow* w, double x, double y) {
        show_cursor(w);
        input(w).move_mouse(x, y);
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
    navigate_by_keyboard();
    set_style(text_scale_);
    touch_screen_.emplace(window_);
    watch_events();  // first: ImGui chains existing callbacks
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    watch_mouse();  // again: new_frame() reports the position
    ImGui_ImplOpenGL3_Init("#version 450");
}

namespace {

/// The monitor that contains the center of the window.
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

/// Waits until the window manager has given the window this size, so that no frame is drawn for the former
/// one. It may choose another size.
void await_size(GLFWwindow* window, int width, int height) {
    constexpr double longest = 0.5;  // seconds
    const double end = glfwGetTime() + longest;
    for (int w = 0, h = 0; glfwGetTime() < end; glfwWaitEventsTimeout(longest / 10)) {
        glfwGetWindowSize(window, &w, &h);
        if (w == width && h == height) return;
    }
}

}  // namespace

void GlfwWindow::fill_screen(bool whole) {
    if (whole == windowed_.has_value()) return;
    if (!whole) {
        const Place p = *std::exchange(windowed_, std::nullopt);
        glfwSetWindowMonitor(window_, nullptr, p.x, p.y, p.width, p.height, GLFW_DONT_CARE);
        return await_size(window_, p.width, p.height);
    }
    GLFWmonitor* monitor = monitor_of(window_);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    Place& p = windowed_.emplace();
    glfwGetWindowPos(window_, &p.x, &p.y);
    glfwGetWindowSize(window_, &p.width, &p.height);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    await_size(window_, mode->width, mode->height);
    // Mesa keeps the size of the window's buffers until they are swapped, so that the next picture would be
    // displaced by the difference of the heights.
    glClear(GL_COLOR_BUFFER_BIT);
    glfwSwapBuffers(window_);
}

float GlfwWindow::fitting_text_scale() const {
    constexpr float pixels_for_plain_text = 1440;  // height of a screen
    float scale = 1, down = 1;
    glfwGetWindowContentScale(window_, &scale, &down);
    GLFWmonitor* monitor = monitor_of(window_);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode) scale = std::max(scale, float(mode->height) / pixels_for_plain_text);
    return std::clamp(scale, 1.0f, max_text_scale);
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
    double x = 0, y = 0;
    glfwGetCursorPos(window_, &x, &y);
    input_.set_mouse(x, y);
    watch_mouse();
    constexpr auto note = [](GLFWwindow* w, auto...) { Callbacks::input(w).note(); };
    glfwSetCharCallback(window_, note);
    glfwSetCursorEnterCallback(window_, note);
    glfwSetScrollCallback(window_, Callbacks::wheel);
    glfwSetWindowFocusCallback(window_, note);
    glfwSetWindowRefreshCallback(window_, note);
    glfwSetWindowIconifyCallback(window_, note);
    glfwSetFramebufferSizeCallback(window_, note);
    glfwSetWindowCloseCallback(window_, note);
}

void GlfwWindow::watch_mouse() {
    glfwSetMouseButtonCallback(window_, Callbacks::button);
    glfwSetCursorPosCallback(window_, Callbacks::cursor);
}

WindowEvents GlfwWindow::events(double seconds) {
    input_.look(glfwGetTime());
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    const std::vector<TouchEvent> touches = touch_screen_->take();
    for (const TouchEvent& t : touches) input_.touch(t, double(text_scale_), glfwGetTime());
    if (!touches.empty()) glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    return input_.take(glfwGetTime());
}

GlfwWindow::~GlfwWindow() {
    touch_screen_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

}  // namespace vantage
