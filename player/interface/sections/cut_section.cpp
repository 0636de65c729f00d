#include "player/interface/sections/cut_section.h"

#include <imgui.h>

#include <algorithm>

#include "base/text/translation.h"
#include "player/interface/overlays/scene_line.h"
#include "player/interface/sections/choice.h"

namespace vantage {
namespace {

/// The plane's unit normal.
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

/// The box is enlarged slightly, because rounding to single precision could otherwise cut a floor at its
/// boundary.
std::vector<SectionPlane> box_of(Cut& cut, const PlanScene& scene) {
    const double margin = 1e-5 * scene.size;
    std::vector<SectionPlane> planes;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
        const auto [low, high] = cut.extents.along(scene, axis);
        const auto at = [&](double share) { return low + share * (high - low); };
        planes.push_back({-axis, margin - at(cut.low[std::size_t(i)])});
        planes.push_back({axis, margin + at(cut.high[std::size_t(i)])});
    }
    return planes;
}

/// A slider for a fraction of the extent from `low` to `high`, in input coordinates.
bool share_slider(Controls& c, const char* name, double& share, double low, double high) {
    double at = low + share * (high - low);
    if (!c.slider(name, &at, low, high, "%.3f") || !(high > low)) return false;
    share = std::clamp((at - low) / (high - low), 0.0, 1.0);
    return true;
}

void plane_controls(Controls& c, Session& s, const PlanScene& scene, const Eigen::Vector3d& origin,
                    bool begins) {
    Cut& cut = s.cut;
    static const char* const across[] = {marked("my view"), marked("x"), marked("y"), marked("z")};
    const Cut::Across before = cut.across;
    choice(c, "Across", cut.across, across);
    c.explain(
        "The plane faces your current position, or is perpendicular to an axis of the model's coordinates.");
    begins |= cut.across != before;
    if (begins && cut.across == Cut::Across::facing) cut.facing = -s.viewpoint.camera.R.row(2).transpose();
    const Eigen::Vector3d axis = axis_of(cut);
    if (cut.across != before)  // a horizontal plane removes the top
        cut.other_side = cut.across != Cut::Across::facing && axis.dot(s.viewpoint.camera.up) < -0.5;
    const auto [low, high] = cut.extents.along(scene, axis);
    const double from = axis.dot(origin);
    share_slider(c, "Cut at", cut.share, from + low, from + high);
    c.explain("Position of the plane along its axis, in the model's unit.");
    c.checkbox("Other side", &cut.other_side);
    c.explain("Removes the part behind the plane instead.");
}

void box_controls(Controls& c, Cut& cut, const PlanScene& scene, const Eigen::Vector3d& origin) {
    static const char* const names[3][2] = {{marked("x from"), marked("x to")},
                                            {marked("y from"), marked("y to")},
                                            {marked("z from"), marked("z to")}};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [least, most] = cut.extents.along(scene, Eigen::Vector3d::Unit(Eigen::Index(i)));
        const double from = origin[Eigen::Index(i)];
        double &low = cut.low[i], &high = cut.high[i];
        if (share_slider(c, names[i][0], low, from + least, from + most)) high = std::max(low, high);
        if (share_slider(c, names[i][1], high, from + least, from + most)) low = std::min(low, high);
    }
    if (c.button("Whole model")) {
        cut.low = {0, 0, 0};
        cut.high = {1, 1, 1};
    }
    c.explain("A box around the whole model.");
}

/// The edges of the box bounded by six planes, in the order of box_of().
void draw_box(ImDrawList& list, std::span<const SectionPlane> planes, const View& view) {
    const auto corner = [&](int bits) {
        Eigen::Vector3d p;
        for (int i = 0; i < 3; ++i) {
            const SectionPlane& plane = planes[std::size_t(2 * i + (bits >> i & 1))];
            p[i] = plane.offset * plane.normal[i];
        }
        return p;
    };
    for (int bits = 0; bits < 8; ++bits)
        for (int i = 0; i < 3; ++i)
            if (!(bits >> i & 1))
                scene_line(list, view, corner(bits), corner(bits | 1 << i), IM_COL32(255, 255, 255, 110), 1);
}

}  // namespace

std::vector<SectionPlane> sections_of(Cut& cut, const PlanScene& scene) {
    if (!cut.on || scene.triangles == 0) return {};
    if (cut.by == Cut::By::box) return box_of(cut, scene);
    const Eigen::Vector3d axis = axis_of(cut);
    const auto [low, high] = cut.extents.along(scene, axis);
    const double side = cut.other_side ? -1 : 1;
    return {SectionPlane{side * axis, side * (low + cut.share * (high - low))}};
}

void cut_section(Controls& c, Session& s, const PlanScene& scene, const Eigen::Vector3d& origin) {
    Cut& cut = s.cut;
    const bool begins = c.checkbox("Cut the model", &cut.on) && cut.on;
    c.explain("Removes a part of the model and outlines the cut.");
    if (!cut.on) return;
    static const char* const by[] = {marked("a plane"), marked("a box")};
    choice(c, "Cut by", cut.by, by);
    c.explain("Removes the part in front of a plane, or outside a box.");
    if (cut.by == Cut::By::plane)
        plane_controls(c, s, scene, origin, begins);
    else
        box_controls(c, cut, scene, origin);
    if (c.button("Export section")) s.window.commands.push_back(SaveCut{});
    c.explain(
        "Writes the lines of the cut as a drawing (DXF) next to the package, in the input's "
        "coordinates.");
}

void CutLines::show(std::span<const PlacedMesh> meshes, std::span<const SectionPlane> planes,
                    const View& view) {
    if (!std::ranges::equal(planes, planes_) || meshes.size() != meshes_) {
        lines_ = section_lines(meshes, planes);
        planes_.assign(planes.begin(), planes.end());
        meshes_ = meshes.size();
    }
    if (planes.empty()) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    if (planes.size() == max_sections) draw_box(list, planes, view);
    for (const auto& [a, b] : lines_) scene_line(list, view, a, b, IM_COL32(255, 90, 60, 255), 2);
}

}  // namespace vantage
