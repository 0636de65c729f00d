#include "player/window/new_frame.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <iterator>
#include <utility>
#include <vector>

namespace vantage {
namespace {

ImVec2 position(const PointerState& p) {
    return p.there ? ImVec2(float(p.x), float(p.y)) : ImVec2(-FLT_MAX, -FLT_MAX);
}

}  // namespace

PointerState mouse_of(GLFWwindow* window) {
    PointerState out{};
    glfwGetCursorPos(window, &out.x, &out.y);
    for (std::size_t b = 0; b < out.down.size(); ++b)
        out.down[b] = glfwGetMouseButton(window, int(b)) == GLFW_PRESS;
    out.there = glfwGetWindowAttrib(window, GLFW_FOCUSED) || glfwGetWindowAttrib(window, GLFW_HOVERED);
    return out;
}

#if IMGUI_VERSION_NUM >= 18700

void point_before_wheel(GLFWwindow* window) {
    const ImVec2 at = position(mouse_of(window));
    ImGui::GetIO().AddMousePosEvent(at.x, at.y);
}

// Keys are in ImGui's queue, which handles the press and the release of a key in separate frames.
void new_frame(const PointerState& mouse, const UserInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    const PointerState p = input.pointer.value_or(mouse);
    const ImVec2 at = position(p);
    io.AddMousePosEvent(at.x, at.y);
    for (std::size_t b = 0; b < p.down.size(); ++b) io.AddMouseButtonEvent(int(b), p.down[b]);
    ImGui::NewFrame();
}

#else

void point_before_wheel(GLFWwindow*) {}

/// Whether the key is Enter, which newer versions of ImGui treat like Space unless text is being typed.
bool uses_marked(const KeyPress& p) {
    const ImGuiIO& io = ImGui::GetIO();
    return io.NavVisible && !io.WantTextInput && (p.key == GLFW_KEY_ENTER || p.key == GLFW_KEY_KP_ENTER);
}

void new_frame(const PointerState& mouse, const UserInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    const PointerState p = input.pointer.value_or(mouse);
    io.MousePos = position(p);
    std::ranges::copy(p.down, io.MouseDown);
    auto& down = io.KeysDown;
    std::vector<int> tapped;
    for (const KeyPress& p : input.keys) {
        io.KeyCtrl |= p.with == KeyPress::With::control;
        const int key = uses_marked(p) ? GLFW_KEY_SPACE : p.key;
        if (key >= 0 && key < int(std::size(down)) && !std::exchange(down[key], true)) tapped.push_back(key);
    }
    ImGui::NewFrame();
    for (const int key : tapped) down[key] = false;
}

#endif

}  // namespace vantage
