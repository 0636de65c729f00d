#include "player/interface/state/user_input.h"

#include <imgui.h>

#include <algorithm>

namespace vantage {

std::optional<Eigen::Vector2d> clicked_pixel(const UserInput& input) {
    if (ImGui::GetIO().WantCaptureMouse || input.clicks.empty()) return {};
    return Eigen::Vector2d(input.clicks.front().x, input.clicks.front().y);
}

bool take_key(UserInput& input, int key) {
    const auto is = [&](const KeyPress& p) { return p.key == key && p.with == KeyPress::With::nothing; };
    const auto at = std::ranges::find_if(input.keys, is);
    if (at == input.keys.end()) return false;
    input.keys.erase(at);
    return true;
}

}  // namespace vantage
