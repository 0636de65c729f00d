#include "player/interface/sections/columns.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "base/text/translation.h"

namespace vantage {
namespace {

/// Whether a check box with this name fits into the window if it begins at `begin`.
bool fits(const char* name, float begin) {
    const float wide = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
                       ImGui::CalcTextSize(tr(name), nullptr, true).x;
    return begin + wide <= ImGui::GetContentRegionMax().x;
}

}  // namespace

void in_second_column(const char* name) {
    const float column = 11 * ImGui::GetFontSize();
    const float end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    if (end <= column && fits(name, column)) ImGui::SameLine(column);
}

void check_boxes(Controls& c, std::initializer_list<CheckBox> boxes) {
    bool first = true;
    for (const CheckBox& box : boxes) {
        if (!box.applies) continue;
        if (!std::exchange(first, false)) in_second_column(box.name);
        c.checkbox(box.name, box.value);
        c.explain(box.help);
    }
}

float width_beside_names() {
    const float names = 9.5f * ImGui::GetFontSize();
    return -std::min(names, 0.55f * ImGui::GetContentRegionAvail().x);
}

}  // namespace vantage
