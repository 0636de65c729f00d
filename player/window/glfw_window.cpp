#include "player/window/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

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
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 450");
}

GlfwWindow::~GlfwWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

}  // namespace vantage
