#include "player/interface/overlays/frusta.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "player/interface/overlays/photo_frustum.h"
#include "player/interface/overlays/scene_line.h"
#include "player/interface/overlays/weight_color.h"
#include "player/interface/sections/image_set_section.h"
#include "player/interface/sections/photo_list_section.h"

namespace vantage {
namespace {

/// Whether the frustum's picture contains a pixel of the view.
bool covers(const PhotoFrustum& f, const View& view, const Eigen::Vector2d& pixel) {
    int left = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        const auto a = project(view.intrinsics, view.cam_from_origin, f.corner[c]),
                   b = project(view.intrinsics, view.cam_from_origin, f.corner[(c + 1) % 4]);
        if (!a || !b) return false;
        const Eigen::Vector2d along = b->pixel - a->pixel, to = pixel - a->pixel;
        left += along.x() * to.y() - along.y() * to.x() > 0 ? 1 : -1;
    }
    return std::abs(left) == 4;
}

void draw(const PhotoFrustum& f, const View& view, ImU32 color, float width) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (std::size_t c = 0; c < 4; ++c) {
        scene_line(list, view, f.center, f.corner[c], color, width);
        scene_line(list, view, f.corner[c], f.corner[(c + 1) % 4], color, width);
    }
}

}  // namespace

void frusta(Session& s, Renderer& renderer, PhotoStrip& strip, const View& view, double now) {
    const PlanScene& scene = renderer.scene();
    const ViewWeights weights = view_weights(view, scene.photos, s.settings.weights);
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const bool points = !ImGui::GetIO().WantCaptureMouse;
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    std::optional<std::uint32_t> under;
    for (std::uint32_t i = 0; i < scene.photos.size(); ++i) {
        if (!is_shown(s.settings.image_sets, scene.photos[i])) continue;
        const PhotoFrustum f = photo_frustum(scene, i);
        if ((f.center - eye).norm() < 0.0012 * scene.size) continue;  // the viewer is at this camera
        const bool used = renderer.planner().uses(i), white = shows_listed_point(s.photo_list, i);
        draw(
            f, view,
            white ? IM_COL32_WHITE : weight_color(weights.distance[i], weights.angle[i], used ? 1.0f : 0.45f),
            used || white ? 2.0f : 1.0f);
        const bool nearer = !under || (f.center - eye).norm() < (scene.poses[*under].center() - eye).norm();
        if (points && nearer && covers(f, view, {double(pointer.x), double(pointer.y)})) under = i;
    }
    if (!under) return;
    draw(photo_frustum(scene, *under), view, IM_COL32_WHITE, 3);
    strip.tooltip(renderer, *under);
    if (!s.window.input.clicks.empty() && !s.window.panels.measure)
        fly_to(s, *under, scene.photos[*under], now);
}

}  // namespace vantage
