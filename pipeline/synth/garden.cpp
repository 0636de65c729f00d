#include "pipeline/synth/garden.h"

#include <cmath>
#include <numbers>

#include "pipeline/synth/country.h"
#include "pipeline/synth/daylight.h"
#include "pipeline/synth/model_builder.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;
constexpr double lawn_height = -0.03;
constexpr int around = 144;  ///< number of segments around the lawn and the hill

Vector3d on_ring(double distance, int piece, double z) {
    const double angle = 2 * pi * piece / around;
    return {distance * std::cos(angle), distance * std::sin(angle), z};
}

void lawn(ModelBuilder& b, double radius) {
    const std::uint32_t middle = b.vertex({0, 0, lawn_height}, Vector3d::UnitZ());
    for (int i = 0; i < around; ++i) b.vertex(on_ring(radius, i, lawn_height), Vector3d::UnitZ());
    for (std::uint32_t i = 0; i < around; ++i)
        b.triangle(middle, middle + 1 + i, middle + 1 + (i + 1) % around, Material::grass);
}

/// The height of the hill at `distance` from the vertical axis through the origin, in the direction `angle`.
double hill_height(const SynthSpec::Garden& g, double distance, double angle) {
    const double up = std::sin(pi / 2 * std::clamp(distance / g.radius - 1, 0.0, 1.0));
    return g.hill * up * up * (0.7 + 0.2 * std::sin(3 * angle + 1) + 0.1 * std::sin(7 * angle));
}

void hill(ModelBuilder& b, const SynthSpec::Garden& g) {
    constexpr int rings = 12;
    const auto at = [&](double ring, int piece) {
        const double distance = g.radius * (1 + ring / rings);
        const double height = hill_height(g, distance, 2 * pi * piece / around);
        return on_ring(distance, piece, lawn_height + height);
    };
    const auto first = std::uint32_t(b.model.mesh.positions.size());
    for (int r = 0; r <= rings; ++r)
        for (int i = 0; i < around; ++i) {
            const Vector3d outward = at(r + 0.1, i) - at(r - 0.1, i), along = at(r, i + 1) - at(r, i - 1);
            b.vertex(at(r, i), outward.cross(along).normalized());
        }
    const auto index = [&](int r, int i) { return first + std::uint32_t(r * around + i % around); };
    for (int r = 0; r < rings; ++r)
        for (int i = 0; i < around; ++i) {
            b.triangle(index(r, i), index(r + 1, i), index(r + 1, i + 1), Material::trees);
            b.triangle(index(r, i), index(r + 1, i + 1), index(r, i + 1), Material::trees);
        }
}

/// In front of each opening above the ground floor, adds two rails and bars spaced at six times their
/// thickness.
void railings(ModelBuilder& b, const SynthSpec& spec) {
    const SynthSpec::Building& s = spec.building;
    const double w = s.width / s.bays, h = s.height / s.floors, t = spec.garden.railing;
    const double low = 0.2 * h, high = 0.42 * h, out = -0.15;
    for (int floor = 1; floor < s.floors; ++floor)
        for (int i = 0; i < s.bays; ++i) {
            const double x = (i + 0.5) * w - s.width / 2, half = 0.3 * w, z = floor * h;
            for (const double rail : {low, high})
                b.box({x, out, z + rail}, {half, t / 2, t / 2}, Material::iron);
            const int bars = std::max(2, int(2 * half / (6 * t)));
            for (int k = 0; k <= bars; ++k)
                b.box({x - half + 2 * half * k / bars, out, z + (low + high) / 2},
                      {t / 2, t / 2, (high - low) / 2}, Material::iron);
        }
}

/// The content of photos of a chapel. Its triangles are smaller than those of the model, and each vertex
/// stores the fraction of the sky that is visible.
SynthModel build_chapel_world(SynthSpec spec) {
    spec.building.max_edge = 0.12;
    ModelBuilder b{build_model(spec), 0};
    if (spec.garden.radius > 0) add_country(b, spec.garden);
    add_daylight(b.model, RayScene(b.model.mesh));
    return std::move(b.model);
}

}  // namespace

void add_garden(ModelBuilder& b, const SynthSpec::Garden& garden) {
    lawn(b, garden.radius);
    if (garden.hill > 0) hill(b, garden);
    b.model.clouds = true;
}

SynthModel build_world(const SynthSpec& spec) {
    if (spec.building.chapel) return build_chapel_world(spec);
    ModelBuilder b{build_model(spec), 0};
    if (!(spec.garden.radius > 0)) return std::move(b.model);
    add_garden(b, spec.garden);
    if (spec.garden.railing > 0) railings(b, spec);
    return std::move(b.model);
}

}  // namespace vantage
