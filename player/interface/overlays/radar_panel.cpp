#include "player/interface/overlays/radar_panel.h"

#include <imgui.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/translation.h"
#include "player/interface/overlays/weight_color.h"
#include "player/interface/sections/image_set_section.h"
#include "player/plan/triangle_corners.h"

namespace vantage {
namespace {

/// Draws the model from above, without its background: its triangles or, if there are many, some of them.
template <class Place>
void draw_model(ImDrawList& list, const PlanScene& scene, std::uint64_t triangles, const Place& place) {
    constexpr std::uint64_t most = 2000;
    for (std::uint64_t t = 0; t < triangles; t += triangles / most + 1)
        if (const auto c = corners_of(scene, std::uint32_t(t)))
            list.AddTriangle(place((*c)[0]), place((*c)[1]), place((*c)[2]), IM_COL32(170, 180, 195, 110),
                             1.5f);
}

}  // namespace

void radar_panel(Controls& controls, Session& s, const Renderer& renderer, const View& view, double now) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(
        ImVec2(float(s.window.free.left + s.window.free.width) - 18 * em, float(s.window.free.top) + em),
        ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(ImVec2(17 * em, 18.6f * em));
    if (!ImGui::Begin(shown_name("Radar").c_str(), &s.window.panels.radar, ImGuiWindowFlags_NoResize))
        return ImGui::End();
    const PlanScene& scene = renderer.scene();
    const Eigen::Vector3d up = s.viewpoint.camera.up, east = up.unitOrthogonal(), north = up.cross(east);
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    double reach = scene.size / 2;
    for (const Pose& pose : scene.poses) reach = std::max(reach, pose.center().norm());
    reach = std::max(reach, eye.norm()) * 1.08;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float side = 16 * em, scale = side / 2 / float(reach);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto place = [&](const Eigen::Vector3d& p) {
        return ImVec2(low.x + side / 2 + float(p.dot(east)) * scale,
                      low.y + side / 2 - float(p.dot(north)) * scale);
    };
    list.AddRectFilled(low, ImVec2(low.x + side, low.y + side), IM_COL32(20, 24, 30, 255), 4);
    draw_model(list, scene, renderer.package().scene().triangles, place);
    const ViewWeights weights = view_weights(view, scene.photos, s.settings.weights);
    const auto arrow = [&](const Pose& pose, ImU32 color, float size) {
        const ImVec2 at = place(pose.center());
        const ImVec2 to = place(pose.center() + pose.direction() * (double(size) / double(scale)));
        list.AddLine(at, to, color, 1.5f);
        list.AddCircleFilled(at, size / 4, color);
    };
    ImGui::InvisibleButton("##radar", ImVec2(side, side));
    controls.note("Radar map");
    const bool clicked = ImGui::IsItemClicked();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::uint32_t nearest = 0;
    double best = 1e30;
    for (std::uint32_t i = 0; i < scene.poses.size(); ++i) {
        if (!is_shown(s.settings.image_sets, scene.photos[i])) continue;
        arrow(scene.poses[i],
              weight_color(weights.distance[i], weights.angle[i], renderer.planner().uses(i) ? 1.0f : 0.5f),
              14);
        const ImVec2 at = place(scene.poses[i].center());
        const double d = std::hypot(double(at.x - mouse.x), double(at.y - mouse.y));
        if (d < best) best = d, nearest = i;
    }
    arrow(view.cam_from_origin, IM_COL32(255, 255, 255, 255), 24);
    if (clicked && best < 16) fly_to(s, nearest, scene.photos[nearest], now);
    ImGui::End();
}

}  // namespace vantage
