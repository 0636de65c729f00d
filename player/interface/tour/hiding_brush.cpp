#include "player/interface/tour/hiding_brush.h"

#include <imgui.h>

#include <algorithm>

#include "base/text/translation.h"

namespace vantage {
namespace {

void draw_circle(float radius) {
    if (ImGui::GetIO().WantCaptureMouse) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 center = ImGui::GetIO().MousePos;
    list.AddCircle(center, radius, IM_COL32(0, 0, 0, 160), 0, 4);
    list.AddCircle(center, radius, IM_COL32_WHITE, 0, 2);
}

}  // namespace

void HidingBrush::take_click(ActiveStory& active, Session& s, const View& view, const SurfaceAt& surface,
                             double now) const {
    const auto pixel = clicked_pixel(s.window.input);
    if (!pixel) return;
    const auto at = surface ? surface(*pixel) : std::nullopt;
    if (!at) return say(s.message, tr("There is nothing to hide here"), now);
    const double depth =
        view.orthographic_depth > 0 ? view.orthographic_depth : std::max(depth_in(view, *at), 1e-9);
    const double radius = diameter_ / 2 * depth / view.intrinsics.fx;
    active.story.hidden.push_back(
        {rounded_place(*at + active.axes.origin, depth), rounded_length(radius, radius)});
    active.changed = true;
}

void HidingBrush::show(Controls& c, ActiveStory& active, Session& s, const View& view,
                       const SurfaceAt& surface, double now) {
    if (c.checkbox("Hide pieces", &s.window.hides_pieces) && s.window.hides_pieces)
        s.window.places_note = s.window.panels.measure = false;  // they take clicks, too
    c.explain(
        "A click hides the model and the background in the circle around the pointer, for visitors as well; "
        "at a photo's own camera, the photo still shows them. Ctrl+Z undoes it.");
    if (!active.story.hidden.empty()) {
        ImGui::SameLine();
        if (c.button("Show all pieces")) {
            active.story.hidden.clear();
            active.changed = true;
        }
    }
    if (!s.window.hides_pieces) return;
    ImGui::SetNextItemWidth(160);
    c.slider("Size of the circle", &diameter_, 8, 400, "%.0f px", ImGuiSliderFlags_Logarithmic);
    draw_circle(float(diameter_ / 2));
    take_click(active, s, view, surface, now);
}

}  // namespace vantage
