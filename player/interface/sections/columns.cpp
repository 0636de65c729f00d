#include "player/interface/sections/columns.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
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

std::vector<std::string> wrapped(const std::string& text, float width) {
    std::vector<std::string> out;
    std::size_t begin = 0;
    for (std::size_t at = 0, last = 0; at <= text.size(); ++at) {
        const bool after_number = at > 0 && std::isdigit(static_cast<unsigned char>(text[at - 1]));
        if (at < text.size() && (text[at] != ' ' || after_number)) continue;
        if (last > begin && ImGui::CalcTextSize(&text[begin], text.data() + at).x > width) {
            out.push_back(text.substr(begin, last - begin));
            begin = last + 1;
        }
        last = at;
    }
    out.push_back(text.substr(begin));
    return out;
}

float width_beside_names() {
    const float names = 9.5f * ImGui::GetFontSize();
    return -std::min(names, 0.55f * ImGui::GetContentRegionAvail().x);
}

}  // namespace vantage
