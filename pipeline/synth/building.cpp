#include "pipeline/synth/building.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "pipeline/synth/chapel.h"
#include "pipeline/synth/model_builder.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

/// One bay of the facade: the wall around an opening, the recess, and the panel at its back.
void bay(ModelBuilder& b, const Vector3d& corner, double w, double h, double recess, Material panel) {
    const double l = 0.22 * w, r = w - l, low = 0.18 * h, top = 0.85 * h;
    const auto wall = [&](double x0, double z0, double x1, double z1) {
        b.quad(corner + Vector3d(x0, 0, z0), Vector3d(x1 - x0, 0, 0), Vector3d(0, 0, z1 - z0),
               Material::brick);
    };
    wall(0, 0, w, low);
    wall(0, top, w, h);
    wall(0, low, l, top);
    wall(r, low, w, top);
    const Vector3d in(0, recess, 0), across(r - l, 0, 0), up(0, 0, top - low),
        at = corner + Vector3d(l, 0, low);
    b.quad(at + in, across, up, panel);
    b.quad(at, in, up, Material::plaster);                 // left side, faces right
    b.quad(at + across + in, -in, up, Material::plaster);  // right side, faces left
    b.quad(at, across, in, Material::plaster);             // sill
    b.quad(at + up + in, across, -in, Material::plaster);  // lintel
}

void facade(ModelBuilder& b, const SynthSpec::Building& s) {
    const Material panels[] = {Material::window, Material::grating, Material::window, Material::text};
    const double w = s.width / s.bays, h = s.height / s.floors;
    for (int floor = 0; floor < s.floors; ++floor)
        for (int i = 0; i < s.bays; ++i)
            bay(b, {i * w - s.width / 2, 0, floor * h}, w, h, s.recess, panels[(i + 2 * floor) % 4]);
}

/// The other three walls, the ceiling, the two slopes of the roof, and the gables.
void shell(ModelBuilder& b, const SynthSpec::Building& s) {
    const double x = s.width / 2;
    const Vector3d up(0, 0, s.height), back(0, s.depth, 0), across(s.width, 0, 0);
    b.quad({x, 0, 0}, back, up, Material::brick);
    b.quad({-x, s.depth, 0}, -back, up, Material::brick);
    b.quad({x, s.depth, 0}, -across, up, Material::brick);
    const double rise = 0.3 * s.height, eaves = 0.4;
    const Vector3d slope(0, s.depth / 2 + eaves, rise), ridge(s.width + 2 * eaves, 0, 0);
    b.quad({-x - eaves, -eaves, s.height}, ridge, slope, Material::roof);
    b.quad({x + eaves, s.depth + eaves, s.height}, -ridge, Vector3d(0, -slope.y(), rise), Material::roof);
    b.quad({-x - eaves, s.depth + eaves, s.height}, ridge, Vector3d(0, -s.depth - 2 * eaves, 0),
           Material::plaster);
    for (const double side : {-1.0, 1.0}) {
        const Vector3d a(side * x, side > 0 ? 0 : s.depth, s.height),
            c(side * x, side > 0 ? s.depth : 0, s.height);
        const Vector3d n(side, 0, 0);
        b.triangle(b.vertex(a, n), b.vertex(c, n),
                   b.vertex({side * x, s.depth / 2, s.height + rise * s.depth / (s.depth + 2 * eaves)}, n),
                   Material::brick);
    }
}

/// A point on the (2,3) torus knot, which lies in the xz plane; t is in [0, 2 pi).
Vector3d knot_at(double t) {
    const double r = 2 + std::cos(3 * t);
    return Vector3d(r * std::cos(2 * t), -std::sin(3 * t) * 1.2, r * std::sin(2 * t)) / 4.2;
}

/// A tube that follows the (2,3) torus knot around `center`; the knot's radius is `size`.
void knot(ModelBuilder& b, const Vector3d& center, double size, int triangles) {
    const double pi = std::numbers::pi;
    const int around = std::max(5, int(std::sqrt(triangles / 2.0 / 10))), along = triangles / 2 / around;
    const auto first = std::uint32_t(b.model.mesh.positions.size());
    for (int i = 0; i < along; ++i) {
        const double t = 2 * pi * i / along;
        const Vector3d tangent = (knot_at(t + 1e-4) - knot_at(t - 1e-4)).normalized();
        const Vector3d n = tangent.cross(Vector3d(0, 1, 0)).normalized(), m = tangent.cross(n);
        for (int j = 0; j < around; ++j) {
            const double a = 2 * pi * j / around;
            const Vector3d out = std::cos(a) * n + std::sin(a) * m;
            b.vertex(center + size * (knot_at(t) + 0.13 * out), out);
        }
    }
    const auto at = [&](int i, int j) { return first + std::uint32_t((i % along) * around + j % around); };
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            b.triangle(at(i, j), at(i + 1, j + 1), at(i + 1, j), Material::marble);
            b.triangle(at(i, j), at(i, j + 1), at(i + 1, j + 1), Material::marble);
        }
}

}  // namespace

SynthModel build_model(const SynthSpec& spec) {
    ModelBuilder b{{}, spec.building.max_edge};
    if (spec.building.chapel) {
        add_chapel(b, spec);
        return std::move(b.model);
    }
    facade(b, spec.building);
    shell(b, spec.building);
    const double ground = spec.building.width;
    b.quad({-ground, -ground, 0}, {2 * ground, 0, 0}, {0, ground, 0}, Material::paving);
    const double plinth = 0.9, size = spec.object.size;
    const Vector3d foot(0, -spec.object.distance, 0);
    b.box(foot + Vector3d(0, 0, plinth / 2), {0.45 * size, 0.35 * size, plinth / 2}, Material::plaster);
    knot(b, foot + Vector3d(0, 0, plinth + 0.9 * size), size, spec.object.triangles);
    return std::move(b.model);
}

}  // namespace vantage
