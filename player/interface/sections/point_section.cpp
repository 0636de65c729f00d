#include "player/interface/sections/point_section.h"

#include <imgui.h>

#include <cstdint>
#include <iterator>
#include <optional>
#include <string>

#include "base/text/localized.h"
#include "base/text/translation.h"
#include "player/survey/number_text.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {

namespace {

/// The point under the pointer. Without a point, uses the same number of lines, so that the panel keeps its
/// size.
void under_pointer(const Renderer& renderer) {
    const std::optional<PickedPoint>& p = renderer.picked();
    const bool shown = p && !ImGui::GetIO().WantCaptureMouse;
    ImGui::TextDisabled("%s", shown ? tr("under the pointer:") : tr("under the pointer: no point"));
    for (int axis = 0; axis < 3; ++axis)
        if (shown)
            ImGui::TextUnformatted(
                (std::string(1, "xyz"[axis]) + "  " +
                 localized_numbers(number_text(p->position[axis], 10, p->position.cwiseAbs().maxCoeff())))
                    .c_str());
        else
            ImGui::TextDisabled(" ");
    if (shown)
        ImGui::Text(tr("color  %d %d %d"), p->color[0], p->color[1], p->color[2]);
    else
        ImGui::TextDisabled(" ");
}

void size_slider(Controls& c, PointSettings& p, double scene_size) {
    const double most = p.by == PointSize::world ? scene_size / 50 : p.by == PointSize::pixels ? 16 : 4;
    c.slider("Point size", &p.size, most / 100, most, "%.3g");
    c.explain("Diameter of a point.");
}

void controls(Controls& c, Session& session, const Renderer& renderer, bool more) {
    PointSettings& p = session.settings.points;
    const bool only = points_only(renderer.package().scene());
    if (only) {
        size_slider(c, p, renderer.scene().size);
    } else {
        static const char* const shown[] = {MARKED_IN("points", "with the model"),
                                            MARKED_IN("points", "alone"), MARKED_IN("points", "hidden")};
        int choice = !p.show ? 2 : p.alone ? 1 : 0;
        if (c.choice("Points", &choice, shown, int(std::size(shown))))
            p.show = choice < 2, p.alone = choice == 1;
        c.explain("The point cloud, with the model or without it.");
    }
    if (!more || !p.show) return;
    if (!renderer.scene().photos.empty()) {
        static const char* const colors[] = {marked("the photos'"), marked("their own")};
        int color = photos_on_points(session.settings, renderer.resources().parts) ? 0 : 1;
        if (c.choice("Colors of points", &color, colors, int(std::size(colors))))
            p.color = color == 0 ? PointColor::photos : PointColor::own;
        c.explain("The colors of the photos that show a point, or those that are stored with the points.");
    }
    static const char* const sizes[] = {marked("fill gaps"), marked("pixels"), marked("input units")};
    int by = int(p.by);
    if (c.choice("Point size by", &by, sizes, int(std::size(sizes)))) {
        p.by = PointSize(by);
        p.size = p.by == PointSize::world ? renderer.scene().size / 1000 : p.by == PointSize::pixels ? 2 : 1;
    }
    c.explain("The spacing of the points, pixels of the picture, or the model's unit.");
    if (!only) size_slider(c, p, renderer.scene().size);
    c.slider("Eye-dome shading", &p.eye_dome, 0.0, 3.0);
    c.explain("Darkens points behind others, so that edges show.");
    double millions = double(p.budget) / 1e6;
    if (c.slider("Million points", &millions, 0.05, 20.0, "%.2f", ImGuiSliderFlags_Logarithmic))
        p.budget = std::uint64_t(millions * 1e6);
    c.explain("Maximum number of points drawn per frame.");
    ImGui::TextDisabled(tr("%zu of %llu points drawn%s"), session.drawn.report.points,
                        static_cast<unsigned long long>(renderer.resources().points->cloud().points),
                        renderer.resources().points->plan().whole ? "" : tr(" (limit reached)"));
}

}  // namespace

void point_section(Controls& c, Session& session, const Renderer& renderer, bool more) {
    controls(c, session, renderer, more);
    if (more) under_pointer(renderer);
}

}  // namespace vantage
