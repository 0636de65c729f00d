#include "player/interface/overlays/comparison.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "base/values/srgb.h"
#include "player/interface/overlays/agreeing_photo.h"
#include "player/interface/overlays/seen_triangle.h"
#include "player/interface/sections/image_set_section.h"
#include "player/plan/triangle_corners.h"
#include "player/plan/visible_surface.h"

namespace vantage {
namespace {

/// Text on a dark background in the picture, recorded as "Legend". `share`: the fraction of the text's width
/// that is to the left of `x`.
void plate(Controls& c, float x, float y, float share, const std::string& text) {
    const float em = ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 low(x - share * size.x, y), high(low.x + size.x, y + size.y);
    list.AddRectFilled(ImVec2(low.x - 0.5f * em, low.y - 0.25f * em),
                       ImVec2(high.x + 0.5f * em, high.y + 0.25f * em), IM_COL32(20, 23, 28, 220), 0.3f * em);
    c.note("Legend", low, high);
    list.AddText(low, IM_COL32_WHITE, text.c_str());
}

/// A crisp line over the one in the picture, which is blurred while the picture moves.
void dividing_line(float x, const Area& free) {
    const float top = float(free.top), bottom = top + float(free.height);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(ImVec2(x - 2.5f, top), ImVec2(x + 2.5f, bottom), IM_COL32(20, 23, 28, 160));
    list.AddRectFilled(ImVec2(x - 1.5f, top), ImVec2(x + 1.5f, bottom), IM_COL32_WHITE);
}

/// A handle around the line, as high as the free area.
void drag_swipe(Controls& c, Session& s, const Area& frame) {
    const float em = ImGui::GetFontSize(), x = float(frame.width * s.settings.swipe),
                top = float(s.window.free.top), high = float(s.window.free.height);
    c.begin_handle("Swipe", ImVec2(x - em, top), ImVec2(2 * em, high));
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive())
        s.settings.swipe =
            std::clamp(double(ImGui::GetIO().MousePos.x) / std::max(1.0, frame.width), 0.0, 1.0);
    ImGui::End();
    const ImVec2 middle(x, top + high / 2);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCircleFilled(middle, 0.9f * em, IM_COL32_WHITE);
    list.AddTriangleFilled(ImVec2(x - 0.7f * em, middle.y), ImVec2(x - 0.2f * em, middle.y - 0.35f * em),
                           ImVec2(x - 0.2f * em, middle.y + 0.35f * em), IM_COL32_BLACK);
    list.AddTriangleFilled(ImVec2(x + 0.7f * em, middle.y), ImVec2(x + 0.2f * em, middle.y + 0.35f * em),
                           ImVec2(x + 0.2f * em, middle.y - 0.35f * em), IM_COL32_BLACK);
}

/// The colors of the shader's count_color, sRGB.
void count_ramp(ImVec2 low, float width, float height) {
    constexpr float stops[5][3] = {{0.058f, 0, 0.089f},
                                   {0.042f, 0.084f, 0.258f},
                                   {0.014f, 0.279f, 0.262f},
                                   {0.114f, 0.584f, 0.119f},
                                   {0.983f, 0.799f, 0.019f}};
    const auto color = [&](int i) {
        const auto encoded = [&](int c) { return float(srgb_from_linear(double(stops[i][c]))); };
        return ImGui::ColorConvertFloat4ToU32(ImVec4(encoded(0), encoded(1), encoded(2), 1));
    };
    for (int i = 0; i < 4; ++i)
        ImGui::GetBackgroundDrawList()->AddRectFilledMultiColor(
            ImVec2(low.x + width * float(i) / 4, low.y),
            ImVec2(low.x + width * float(i + 1) / 4, low.y + height), color(i), color(i + 1), color(i + 1),
            color(i));
}

/// Whether one of the photos sees the side of a triangle that faces the eye.
bool is_photographed(const PlanScene& scene, std::span<const std::uint32_t> photos, std::uint32_t triangle,
                     const Eigen::Vector3d& eye) {
    const auto corners = corners_of(scene, triangle);
    if (!corners) return true;
    const auto& [a, b, c] = *corners;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const bool front = normal.dot(eye - a) > 0;
    return std::ranges::any_of(photos, [&](std::uint32_t p) {
        return !scene.visible[p].empty() && sees(scene, p, triangle) &&
               (normal.dot(scene.poses[p].center() - a) > 0) == front;
    });
}

/// The fraction of an area of the window that shows a part of the mesh that none of these photos sees.
double unseen_share(const PlanScene& scene, std::span<const std::uint32_t> photos, const SeenTriangles& seen,
                    const Area& area) {
    constexpr int side = 48;  // samples
    const Intrinsics& k = seen.view.intrinsics;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const Eigen::Vector3d eye = seen.view.cam_from_origin.center();
    int unseen = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Eigen::Vector2d at(area.left + area.width * (x + 0.5) / side,
                                     area.top + area.height * (y + 0.5) / side);
            const std::uint32_t triangle = seen_triangle(
                seen, {at.x() * k.width / double(window.x), at.y() * k.height / double(window.y)});
            unseen += triangle > 0 && triangle <= scene.first_triangle_behind() &&
                      !is_photographed(scene, photos, triangle - 1, eye);
        }
    return double(unseen) / (side * side);
}

}  // namespace

void comparison(Controls& c, Session& s, const PlanScene& scene, const Area& frame) {
    const RenderSettings& r = s.settings;
    if (r.compare == Compare::nothing || r.compare_photo >= scene.photos.size()) return;
    const char* const photo = scene.photos[r.compare_photo].name;
    const float em = ImGui::GetFontSize(), y = float(s.window.free.top) + em;
    const auto both = [&](double line) {
        const float x = std::round(float(line * frame.width)) + 0.5f;
        dividing_line(x, s.window.free);
        plate(c, x - 1.5f * em, y, 1, tr("model without this photo"));
        // File names are for experts; the strip marks the photo.
        plate(c, x + 1.5f * em, y, 0,
              s.window.panels.expert ? formatted(tr("photo %s"), photo) : std::string(tr("photo")));
    };
    switch (r.compare) {
        case Compare::side_by_side:
            return both(0.5);
        case Compare::swipe:
            both(r.swipe);
            return drag_swipe(c, s, frame);
        case Compare::difference:
            return plate(c, float(s.window.free.left + s.window.free.width / 2), y, 0.5f,
                         formatted(tr("difference from photo %s, doubled; black: none"), photo));
        default:
            return;
    }
}

void toggle_comparison(Session& s, const PlanScene& scene, const View& view, double now) {
    if (s.settings.compare != Compare::nothing) {
        s.settings.compare = Compare::nothing;
        return;
    }
    const auto photo = agreeing_photo(scene, view, s.settings.image_sets);
    if (!photo) return;
    s.settings.compare = Compare::swipe;
    s.settings.image_sets.how = ImageSetView::mix;  // one comparison at a time
    fly_to(s, *photo, scene.photos[*photo], now);
}

void end_comparison_off_photo(Session& s, const PlanScene& scene, double now) {
    constexpr double farthest = 0.01;  // fraction of the distance to the target
    const std::uint32_t photo = s.settings.compare_photo;
    if (s.settings.compare == Compare::nothing || photo >= scene.poses.size()) return;
    const auto& flight = s.viewpoint.flight;
    const bool flies_on = flight && (flight->along || flight->repeats || flight->stops.empty());
    const Navigation& camera = flight && !flies_on ? flight->stops.back() : s.viewpoint.camera;
    const double away = (scene.poses[photo].center() - camera.eye).norm();
    if (!flies_on && away < farthest * (camera.target - camera.eye).norm()) return;
    s.settings.compare = Compare::nothing;
    say(s.message, tr("The comparison has ended, because the view has left the photo"), now);
}

void false_color_legend(Controls& c, const Session& s, const PlanScene& scene) {
    const float em = ImGui::GetFontSize(), x = float(s.window.free.left) + em,
                y = float(s.window.free.top + s.window.free.height) - 2 * em;
    if (s.settings.show == Show::sources)
        plate(c, x, y, 0, tr("each color is a photo, outlined in the same color in the strip"));
    if (s.settings.show != Show::coverage) return;
    const std::string most = std::to_string(s.drawn.report.photos);
    const auto all = std::ranges::count_if(scene.photos, [&](const package::PhotoRecord& p) {
        return p.levels && is_shown(s.settings.image_sets, p);
    });
    const std::string before =
        formatted(tr("blended photos (of %zu) that show the surface: 0 "), std::size_t(all));
    plate(c, x, y, 0, before + std::string(24, ' ') + " " + most);
    const float from = x + ImGui::CalcTextSize(before.c_str()).x,
                width = ImGui::CalcTextSize(std::string(24, ' ').c_str()).x;
    count_ramp(ImVec2(from, y), width, em);
}

void UnseenLegend::show(Controls& c, const Session& s, const PlanScene& scene, const SeenTriangles& seen) {
    constexpr double begins = 0.06, ends = 0.03;  // of the picture
    const RenderSettings& r = s.settings;
    if (!r.fill_holes || r.show != Show::colors || r.compare != Compare::nothing || r.field.index >= 0 ||
        (r.light.light != Light::photos && !r.light.on_photos) || r.points.alone)
        return;
    const Area& free = s.window.free;
    if (version_ != seen.version || photos_ != s.photos) {
        version_ = seen.version;
        photos_ = s.photos;
        notable_ = unseen_share(scene, photos_, seen, free) > (notable_ ? ends : begins);
    }
    if (notable_)
        plate(c, float(free.left + free.width / 2), float(free.top + free.height) - 2 * ImGui::GetFontSize(),
              0.5f, tr("Gray or blurred surface was not photographed"));
}

}  // namespace vantage
