#include "player/window/new_frame.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <iterator>
#include <utility>
#include <vector>

namespace vantage {

void new_frame(const Session& session) {
    ImGuiIO& io = ImGui::GetIO();
    if (const auto& p = session.input.pointer) {
        io.MousePos = p->there ? ImVec2(float(p->x), float(p->y)) : ImVec2(-FLT_MAX, -FLT_MAX);
        std::ranges::copy(p->down, io.MouseDown);
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
