#include "player/window/new_frame.h"

#include <imgui.h>

#include <cfloat>
#include <iterator>
#include <utility>
#include <vector>

namespace vantage {

void new_frame(const Session& session) {
    ImGuiIO& io = ImGui::GetIO();
    if (const auto& finger = session.input.finger) {
        io.MousePos = finger->there ? ImVec2(float(finger->x), float(finger->y)) : ImVec2(-FLT_MAX, -FLT_MAX);
        io.MouseDown[0] = finger->down;
    }
    auto& down = io.KeysDown;
    std::vector<int> tapped;
    for (const KeyPress& p : session.input.keys) {
        io.KeyCtrl |= p.with == KeyPress::With::control;
        if (p.key >= 0 && p.key < int(std::size(down)) && !std::exchange(down[p.key], true))
            tapped.push_back(p.key);
    }
    ImGui::NewFrame();
    for (const int key : tapped) down[key] = false;
}

}  // namespace vantage
