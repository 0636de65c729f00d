#include "player/survey/section.h"

#include <algorithm>
#include <cstdio>

namespace vantage {
namespace {

/// Adds the line in which the plane cuts a triangle, if it does.
void cut(const std::array<Eigen::Vector3d, 3>& corner, const SectionPlane& plane, const PlacedMesh& m,
         std::vector<SectionLine>& out) {
    std::array<double, 3> before;
    for (std::size_t i = 0; i < 3; ++i) before[i] = plane.before(corner[i]);
    SectionLine line;
    std::size_t ends = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if ((before[i] > 0) == (before[j] > 0) || ends == 2) continue;
        const double share = before[i] / (before[i] - before[j]);
        const Eigen::Vector3d at = corner[i] + share * (corner[j] - corner[i]);
        line[ends++] = m.scale * (m.R * at) + m.t;
    }
    if (ends == 2 && line[0].allFinite() && line[1].allFinite()) out.push_back(line);
}

void cut_mesh(const PlacedMesh& m, const SectionPlane& of_scene, std::vector<SectionLine>& out) {
    const PlanScene& scene = *m.scene;
    const SectionPlane plane = plane_in(of_scene, m.R, m.t, m.scale);
    const std::size_t clusters = std::min<std::size_t>(scene.first_surrounding, scene.clusters.size());
    for (const package::ClusterRecord& c : std::span(scene.clusters).first(clusters)) {
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

}  // namespace

std::vector<SectionLine> section_lines(std::span<const PlacedMesh> meshes, const SectionPlane& plane) {
    std::vector<SectionLine> out;
    for (const PlacedMesh& m : meshes) cut_mesh(m, plane, out);
    return out;
}

std::string section_dxf(std::span<const SectionLine> lines, const Eigen::Vector3d& origin) {
    std::string out = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    for (const SectionLine& line : lines) {
        out += "0\nLINE\n8\nSECTION\n";
        for (int end = 0; end < 2; ++end)
            for (int axis = 0; axis < 3; ++axis) {
                char text[64];
                std::snprintf(text, sizeof text, "%d\n%.12g\n", 10 * (axis + 1) + end,
                              line[std::size_t(end)][axis] + origin[axis]);
                out += text;
            }
    }
    return out + "0\nENDSEC\n0\nEOF\n";
}

RayRange behind(const SectionPlane& plane, const Ray& ray) {
    RayRange range;
    const double before = plane.before(ray.from), speed = plane.normal.dot(ray.along);
    if (speed > 0) range.farthest = -before / speed;
    if (speed < 0) range.nearest = std::max(0.0, before / -speed);
    if (speed == 0 && before > 0) range.farthest = -1;
    return range;
}

std::array<double, 2> extent_along(const PlanScene& scene, const Eigen::Vector3d& normal) {
    std::array<double, 2> out{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
    const std::size_t clusters = std::min<std::size_t>(scene.first_surrounding, scene.clusters.size());
    for (const package::ClusterRecord& c : std::span(scene.clusters).first(clusters)) {
        const double at = normal.dot(Eigen::Vector3d(c.center[0], c.center[1], c.center[2]));
        out[0] = std::min(out[0], at - double(c.radius));
        out[1] = std::max(out[1], at + double(c.radius));
    }
    return out[0] <= out[1] ? out : std::array{0.0, 0.0};
}

}  // namespace vantage
