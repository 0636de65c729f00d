#include "player/survey/section.h"

#include <algorithm>

#include "base/text/formatted.h"

namespace vantage {
namespace {

/// Adds the intersection of the plane with a triangle, if any, see SectionLine.
void cut(const std::array<Eigen::Vector3d, 3>& corner, const SectionPlane& plane, const PlacedMesh& m,
         std::vector<SectionLine>& out) {
    std::array<double, 3> before;
    for (std::size_t i = 0; i < 3; ++i) before[i] = plane.before(corner[i]);
    SectionLine line;
    std::size_t ends = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if ((before[i] > 0) == (before[j] > 0)) continue;
        const double share = before[i] / (before[i] - before[j]);
        const Eigen::Vector3d at = corner[i] + share * (corner[j] - corner[i]);
        ++ends;
        line[before[i] > 0 ? 0 : 1] = m.in_scene(at);
    }
    if (ends == 2 && line[0].allFinite() && line[1].allFinite()) out.push_back(line);
}

void cut_mesh(const PlacedMesh& m, const SectionPlane& of_scene, std::vector<SectionLine>& out) {
    const PlanScene& scene = *m.scene;
    const SectionPlane plane = plane_in(of_scene, m.R, m.t, m.scale);
    for (const package::ClusterRecord& c : scene.clusters_of_mesh()) {
        const Eigen::Vector3d center(c.center[0], c.center[1], c.center[2]);
        if (!(std::abs(plane.before(center)) <= double(c.radius) * (1 + 1e-5))) continue;
        for (std::uint32_t t = c.first_triangle; t < c.first_triangle + c.triangles; ++t) {
            const std::uint32_t* v = &scene.indices[3 * std::size_t(t)];
            if (*std::max_element(v, v + 3) >= scene.positions.size()) return;  // the file was overwritten
            cut({scene.positions[v[0]].cast<double>(), scene.positions[v[1]].cast<double>(),
                 scene.positions[v[2]].cast<double>()},
                plane, m, out);
        }
    }
}

std::span<const std::uint32_t> vertices_of(const PlanScene& scene, const package::ClusterRecord& c) {
    return std::span(scene.indices).subspan(3 * std::size_t(c.first_triangle), 3 * std::size_t(c.triangles));
}

/// Shortens a line to the part behind the planes; returns false if nothing remains.
bool shorten(SectionLine& line, std::span<const SectionPlane> planes) {
    const Ray along{line[0], line[1] - line[0]};
    const RayRange range = behind(planes, along);
    const double to = std::min(1.0, range.farthest);
    if (range.nearest > to) return false;
    line = {along.from + range.nearest * along.along, along.from + to * along.along};
    return true;
}

}  // namespace

std::vector<SectionLine> section_lines(std::span<const PlacedMesh> meshes,
                                       std::span<const SectionPlane> planes) {
    std::vector<SectionLine> out;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        std::vector<SectionPlane> others(planes.begin(), planes.end());
        others.erase(others.begin() + std::ptrdiff_t(i));
        const std::vector<SectionLine> lines = lines_in(meshes, planes[i], others);
        out.insert(out.end(), lines.begin(), lines.end());
    }
    return out;
}

std::vector<SectionLine> lines_in(std::span<const PlacedMesh> meshes, const SectionPlane& plane,
                                  std::span<const SectionPlane> others) {
    std::vector<SectionLine> out;
    for (const PlacedMesh& m : meshes) cut_mesh(m, plane, out);
    std::erase_if(out, [&](SectionLine& line) { return !shorten(line, others); });
    return out;
}

std::string section_dxf(std::span<const SectionLine> lines, const Eigen::Vector3d& origin) {
    std::string out = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    for (const SectionLine& line : lines) {
        out += "0\nLINE\n8\nSECTION\n";
        for (int end = 0; end < 2; ++end)
            for (int axis = 0; axis < 3; ++axis)
                out += formatted("%d\n%.12g\n", 10 * (axis + 1) + end,
                                 line[std::size_t(end)][axis] + origin[axis]);
    }
    return out + "0\nENDSEC\n0\nEOF\n";
}

RayRange behind(std::span<const SectionPlane> planes, const Ray& ray) {
    RayRange range;
    for (const SectionPlane& plane : planes) {
        const double before = plane.before(ray.from), speed = plane.normal.dot(ray.along);
        if (speed > 0) range.farthest = std::min(range.farthest, -before / speed);
        if (speed < 0) range.nearest = std::max(range.nearest, before / -speed);
        if (speed == 0 && before > 0) range.farthest = -1;
    }
    return range;
}

std::array<double, 2> extent_along(const PlanScene& scene, const Eigen::Vector3d& normal) {
    std::array<double, 2> out{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
    const std::size_t clusters = std::min<std::size_t>(scene.first_surrounding, scene.clusters.size());
    for (const package::ClusterRecord& c : std::span(scene.clusters).first(clusters)) {
        const double at = normal.dot(Eigen::Vector3d(c.center[0], c.center[1], c.center[2]));
        const double reach = double(c.radius) * (1 + 1e-5);
        if (at - reach >= out[0] && at + reach <= out[1]) continue;
        for (const std::uint32_t v : vertices_of(scene, c)) {
            if (v >= scene.positions.size()) return {0, 0};  // the file was overwritten
            const double value = normal.dot(scene.positions[v].cast<double>());
            out = {std::min(out[0], value), std::max(out[1], value)};
        }
    }
    return out[0] <= out[1] ? out : std::array{0.0, 0.0};
}

std::array<double, 2> KnownExtents::along(const PlanScene& scene, const Eigen::Vector3d& normal) {
    for (const auto& [direction, extent] : known_)
        if (direction == normal) return extent;
    if (known_.size() == most) known_.clear();
    return known_.emplace_back(normal, extent_along(scene, normal)).second;
}

}  // namespace vantage
