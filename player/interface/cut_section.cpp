#include "player/interface/cut_section.h"

#include <imgui.h>

#include "player/interface/choice.h"
#include "player/interface/columns.h"
#include "player/interface/scene_line.h"

namespace vantage {
namespace {

/// Of length 1: the plane lies across it.
Eigen::Vector3d axis_of(const Cut& cut) {
    switch (cut.across) {
        case Cut::Across::x:
            return Eigen::Vector3d::UnitX();
        case Cut::Across::y:
            return Eigen::Vector3d::UnitY();
        case Cut::Across::z:
            return Eigen::Vector3d::UnitZ();
        default:
            return cut.facing;
    }
}

}  // namespace

std::optional<SectionPlane> section_of(const Cut& cut, const PlanScene& scene) {
    if (!cut.on || scene.triangles == 0) return {};
    const Eigen::Vector3d axis = axis_of(cut);
    const auto [low, high] = extent_along(scene, axis);
    const double side = cut.other_side ? -1 : 1;
    return SectionPlane{side * axis, side * (low + cut.share * (high - low))};
}

void cut_section(Controls& c, Session& s, const PlanScene& scene, const Eigen::Vector3d& origin) {
    Cut& cut = s.cut;
    bool begins = c.checkbox("Cut the model", &cut.on) && cut.on;
    c.explain("Takes away what is in front of a plane, and draws where the plane cuts the model.");
    in_second_column("Other side");
    c.checkbox("Other side", &cut.other_side);
    c.explain("Takes away what is behind the plane instead.");
    ImGui::BeginDisabled(!cut.on);
    static const char* const across[] = {"my view", "x", "y", "z"};
    const Cut::Across before = cut.across;
    choice(c, "Across", cut.across, across);
    c.explain("The plane faces you as you stand now, or lies across an axis of the model's coordinates.");
    begins |= cut.across != before;
    if (begins && cut.across == Cut::Across::facing) cut.facing = -s.camera.R.row(2).transpose();
    const Eigen::Vector3d axis = axis_of(cut);
    const auto [low, high] = extent_along(scene, axis);
    const double from = axis.dot(origin);
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
