#include "player/interface/overlays/photo_marks.h"

#include <algorithm>

#include "base/text/translation.h"

namespace vantage {
namespace {

constexpr ImU32 mark_color = IM_COL32(255, 255, 255, 255), plate_color = IM_COL32(15, 18, 22, 230);

ImVec2 inset(ImVec2 corner, float right, float down) { return {corner.x + right, corner.y + down}; }

/// Light dashes on a dark line, along one side.
void dashed_line(ImDrawList& list, ImVec2 from, ImVec2 to, float dash) {
    const float length = std::max(to.x - from.x, to.y - from.y);
    list.AddLine(from, to, plate_color, 3);
    for (float at = 0; at < length; at += 2 * dash) {
        const float begin = at / length, end = std::min(1.0f, (at + dash) / length);
        const auto point = [&](float share) {
            return ImVec2(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
        };
        list.AddLine(point(begin), point(end), mark_color, 2);
    }
}

void dashed_outline(ImDrawList& list, ImVec2 low, ImVec2 high, float dash) {
    dashed_line(list, low, {high.x, low.y}, dash);
    dashed_line(list, {low.x, high.y}, high, dash);
    dashed_line(list, low, {low.x, high.y}, dash);
    dashed_line(list, {high.x, low.y}, high, dash);
}

void check_mark(ImDrawList& list, ImVec2 at, float r) {
    const ImVec2 points[] = {inset(at, -0.5f * r, 0), inset(at, -0.1f * r, 0.4f * r),
                             inset(at, 0.5f * r, -0.4f * r)};
    list.AddCircleFilled(at, r, plate_color);
    list.AddPolyline(points, 3, mark_color, 0, 2);
}

void cross(ImDrawList& list, ImVec2 at, float r) {
    list.AddCircleFilled(at, r, plate_color);
    list.AddLine(inset(at, -0.4f * r, -0.4f * r), inset(at, 0.4f * r, 0.4f * r), mark_color, 2);
    list.AddLine(inset(at, -0.4f * r, 0.4f * r), inset(at, 0.4f * r, -0.4f * r), mark_color, 2);
}

void pointer_down(ImDrawList& list, ImVec2 at, float r) {
    list.AddCircleFilled(at, r, plate_color);
    list.AddTriangleFilled(inset(at, -0.5f * r, -0.3f * r), inset(at, 0.5f * r, -0.3f * r),
                           inset(at, 0, 0.5f * r), mark_color);
}

void target(ImDrawList& list, ImVec2 at, float r) {
    list.AddCircleFilled(at, r, plate_color);
    list.AddCircle(at, 0.6f * r, mark_color, 0, 2);
    list.AddCircleFilled(at, 0.2f * r, mark_color);
}

}  // namespace

void draw_photo_marks(ImDrawList& list, ImVec2 low, ImVec2 high, const PhotoState& state, ImU32 color) {
    const float r = 0.55f * ImGui::GetFontSize(), d = r + 4;
    if (state.excluded) {
        list.AddRectFilled(low, high, IM_COL32(0, 0, 0, 140));
        dashed_outline(list, low, high, 0.5f * ImGui::GetFontSize());
    }
    if (state.blended || state.pointed_at)
        list.AddRect(low, high, color, 0, 0, state.pointed_at ? 4.0f : 2.5f);
    if (state.viewed_from)
        for (const float gap : {4.0f, 7.0f})
            list.AddRect(inset(low, gap, gap), inset(high, -gap, -gap), gap < 5 ? plate_color : mark_color, 0,
                         0, 2);
    if (state.excluded) cross(list, {high.x - d, low.y + d}, r);
    if (state.blended) check_mark(list, {low.x + d, low.y + d}, r);
    if (state.viewed_from) pointer_down(list, {(low.x + high.x) / 2, low.y + d}, r);
    if (state.shows_point) target(list, {low.x + d, high.y - d}, r);
}

std::string photo_state_text(const PhotoState& state) {
    std::string out;
    const auto add = [&](bool is, const char* text) {
        if (is) out += (out.empty() ? "" : ", ") + std::string(text);
    };
    add(state.excluded, tr_in("photo", "excluded"));
    add(state.blended, tr_in("photo", "blended"));
    add(state.viewed_from, tr_in("photo", "you are here"));
    add(state.shows_point, tr_in("photo", "shows the point"));
    return out;
}

}  // namespace vantage
