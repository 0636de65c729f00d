#include "player/interface/cut_section.h"

#include <imgui.h>

#include "player/interface/choice.h"
#include "player/interface/columns.h"
#include "player/interface/scene_line.h"

namespace vantage {
namespace {

Eigen::Vector3d normal_of(const Cut& cut) {
    using Across = Cut::Across;
    const Eigen::Vector3d normal = cut.across == Across::x   ? Eigen::Vector3d::UnitX()
                                   : cut.across == Across::y ? Eigen::Vector3d::UnitY()
                                   : cut.across == Across::z ? Eigen::Vector3d::UnitZ()
                                                             : cut.facing;
    return cut.other_side ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace

std::optional<SectionPlane> section_of(const Cut& cut, const PlanScene& scene) {
    if (!cut.on || scene.triangles == 0) return {};
    const Eigen::Vector3d normal = normal_of(cut);
    const auto [low, high] = extent_along(scene, normal);
    const double share = cut.other_side ? 1 - cut.share : cut.share;
    return SectionPlane{normal, low + share * (high - low)};
}

void cut_section(Controls& c, Session& s, const PlanScene& scene, const Eigen::Vector3d& origin) {
    Cut& cut = s.cut;
    if (c.checkbox("Cut the model", &cut.on) && cut.on && cut.across == Cut::Across::facing)
        cut.facing = -s.camera.R.row(2).transpose();
    c.explain("Takes away what is in front of a plane, and draws where the plane cuts the model.");
    in_second_column("Other side");
    c.checkbox("Other side", &cut.other_side);
    c.explain("Takes away what is behind the plane instead.");
    ImGui::BeginDisabled(!cut.on);
    static const char* const across[] = {"my view", "x", "y", "z"};
    const Cut::Across before = cut.across;
    choice(c, "Across", cut.across, across);
    c.explain("The plane faces you as you stand now, or lies across an axis of the model's coordinates.");
    if (cut.across != before && cut.across == Cut::Across::facing)
        cut.facing = -s.camera.R.row(2).transpose();
    Cut upright = cut;
    upright.other_side = false;
    const Eigen::Vector3d normal = normal_of(upright);
    const auto [low, high] = extent_along(scene, normal);
    const double from = normal.dot(origin);
    double at = from + low + cut.share * (high - low);
    if (c.slider("Cut at", &at, from + low, from + high, "%.3f") && high > low)
        cut.share = std::clamp((at - from - low) / (high - low), 0.0, 1.0);
    c.explain("Where the plane is along its axis, in the model's unit.");
    if (c.button("Write the cut")) cut.saves = true;
    c.explain(
        "Writes the lines of the cut as a drawing (DXF) into the current folder, in the input's "
        "coordinates.");
    ImGui::EndDisabled();
}

void CutLines::show(std::span<const PlacedMesh> meshes, const std::optional<SectionPlane>& plane,
                    const View& view) {
    if (plane != plane_ || meshes.size() != meshes_) {
        lines_ = plane ? section_lines(meshes, *plane) : std::vector<SectionLine>{};
        plane_ = plane;
        meshes_ = meshes.size();
    }
    if (!plane) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const auto& [a, b] : lines_) scene_line(list, view, a, b, IM_COL32(255, 90, 60, 255), 2);
}

}  // namespace vantage
