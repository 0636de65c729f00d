#include "pipeline/synth/chapel.h"

#include <numbers>

#include "pipeline/synth/urn.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Profile = std::vector<Vector2d>;  ///< x: outward, across the path; y: out of the wall

constexpr double turn = 2 * std::numbers::pi;

/// An opening in a wall. It is either arched, rising from `sill` to `spring`, where the arch starts, or
/// round, with its center at the height `spring`.
struct Opening {
    double x, sill, spring, radius;
    bool round = false;

    Opening wider(double by) const { return {x, sill, spring, radius + by, round}; }
    double rise(double at) const { return std::sqrt(std::max(0.0, radius * radius - (at - x) * (at - x))); }
    double low(double at) const { return round ? spring - rise(at) : sill; }
    double high(double at) const { return spring + rise(at); }
    /// Position of a profile point at t along the opening's outline, which starts at the lower left.
    Vector3d around(double t, const Vector2d& p) const {
        const double r = radius + p.x(),
                     half = round ? t * turn : std::clamp(2 * t - 0.5, 0.0, 1.0) * turn / 2;
        const double up = round ? 0 : std::min({0.0, 4 * t - 1, 3 - 4 * t}) * (spring - sill);
        return {x - r * std::cos(half), -p.y(), spring + up + r * std::sin(half)};
    }
};

/// A profile of three quarters of a circle.
Profile roll(const Vector2d& center, double radius) {
    Profile out;
    for (int i = 0; i <= 8; ++i) {
        const double angle = turn * (0.625 - 0.75 * i / 8);
        out.push_back(center + radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    return out;
}

void block(ModelBuilder& b, const Vector3d& low, const Vector3d& high, Material material) {
    b.box((low + high) / 2, (high - low) / 2, material);
    b.quad(low, {0, high.y() - low.y(), 0}, {high.x() - low.x(), 0, 0}, material);
}

/// A molding: each pair of neighboring points of the profile is swept into one face.
void moulding(ModelBuilder& b, const Profile& edges, int steps,
              const std::function<Vector3d(double, const Vector2d&)>& at) {
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        b.sweep(std::span(edges).subspan(i, 2), steps, at, Material::limestone);
}

/// A piece of wall in the plane at this y, as wide as the opening; its lower and upper limits depend on x.
void wall(ModelBuilder& b, const Opening& o, const std::function<double(double)>& low,
          const std::function<double(double)>& high, double y = 0, Material material = Material::ashlar) {
    b.surface(
        24, 1,
        [&](double u, double v) {
            const double x = o.x - o.radius * std::cos(u * turn / 2);
            return Vector3d(x, y, low(x) + v * (high(x) - low(x)));
        },
        material);
}

/// The wall from x0 to x1 and from z = low to `high`, with the opening cut out of it.
void pierced_wall(ModelBuilder& b, double x0, double x1, double low,
                  const std::function<double(double)>& high, const Opening& o) {
    const auto bottom = [&](double) { return low; };
    for (const auto& [from, to] : {std::pair(x0, o.x - o.radius), std::pair(o.x + o.radius, x1)})
        wall(b, {(from + to) / 2, 0, 0, (to - from) / 2}, bottom, high);
    wall(b, o, bottom, [&](double x) { return o.low(x); });
    wall(
        b, o, [&](double x) { return o.high(x); }, high);
}

/// The stepped reveal around an opening, from the panel at its back out to the face of the wall. Each step
/// but the outermost has a roll molding that follows the opening; on every other one, the arch is beaded.
void reveal(ModelBuilder& b, const Opening& o, double recess, int orders, double step) {
    for (int k = 0; k < orders; ++k) {
        const double r = k * step, y0 = recess * (k - orders) / orders, y1 = y0 + recess / orders;
        const auto around = [&](double t, const Vector2d& p) { return o.around(t, p); };
        moulding(b, {{r, y0}, {r, y1}, {r + step, y1}}, 40, around);
        if (k + 1 == orders) break;
        const double thick = 0.34 * step;
        const Vector2d center(r + step - thick, y1 + thick);
        const auto beaded = [&](double t, const Vector2d& p) {
            const double bead = std::abs(std::sin(t * turn * 4 * o.radius / step));
            const bool carved = o.round || (t > 0.26 && t < 0.74);
            return o.around(t, center + (p - center) * (carved && k % 2 == 0 ? 0.6 + 0.5 * bead : 1.0));
        };
        b.sweep(roll(center, thick), int(150 * o.radius), beaded, Material::limestone);
    }
    const double edge = orders * step;
    moulding(b, {{edge, 0}, {edge, 0.09}, {edge + 0.1, 0.12}, {edge + 0.14, 0}}, 40,
             [&](double t, const Vector2d& p) { return o.around(t, p); });
    wall(
        b, o, [&](double x) { return o.low(x); }, [&](double x) { return o.high(x); }, recess,
        o.sill < 1 && !o.round ? Material::wood : Material::leads);
    if (o.round) return;
    const Opening wide = o.wider(edge);
    b.quad({o.x - wide.radius, 0, o.sill}, {2 * wide.radius, 0, 0}, {0, recess, 0}, Material::limestone);
    for (int k = 0; k < orders; ++k)
        for (const double side : {-1.0, 1.0})
            for (const auto& [z, height, out] :
                 {std::tuple(o.spring - 0.14, 0.14, 0.06), std::tuple(o.sill, 0.24, 0.03)}) {
                const double in = o.x + side * (o.radius + k * step - out),
                             far = o.x + side * (wide.radius + out),
                             front = recess * (orders - 1 - k) / orders - out;
                block(b, {std::min(in, far), front, z}, {std::max(in, far), recess, z + height},
                      Material::limestone);
            }
}

/// Rings in a round window.
void tracery(ModelBuilder& b, const Opening& o, double depth) {
    const auto ring = [&](double x, double z, double radius) {
        const Opening circle{x, 0, z, radius, true};
        b.sweep(
            roll({0, -depth}, 0.045), 24, [&](double t, const Vector2d& p) { return circle.around(t, p); },
            Material::limestone);
    };
    ring(o.x, o.spring, 0.27 * o.radius);
    for (int i = 0; i < 8; ++i)
        ring(o.x + 0.63 * o.radius * std::cos(turn * i / 8),
             o.spring + 0.63 * o.radius * std::sin(turn * i / 8), 0.25 * o.radius);
}

/// A cornice and a row of small arches along one slope of the gable, from its lower end at x0 to its top.
void raking_cornice(ModelBuilder& b, double x0, const std::function<double(double)>& top) {
    const double side = x0 < 0 ? 1 : -1;
    const Vector3d apex(0, 0, top(0)), end(1.08 * x0, 0, top(0) + 1.08 * (top(x0) - top(0)));
    const Vector3d from = side > 0 ? end : apex, to = side > 0 ? apex : end;
    const Profile edges{{-0.16, 0}, {-0.16, 0.12}, {-0.06, 0.16}, {-0.02, 0.3}, {0.14, 0.34}, {0.14, -0.1}};
    moulding(b, edges, 1, [&](double t, const Vector2d& p) {
        return Vector3d(from + t * (to - from) + Vector3d(0, -p.y(), p.x()));
    });
    constexpr double half = 0.14;
    for (double x = 0.36; x < std::abs(x0) - 0.5; x += 2 * half + 0.09) {
        const double at = -side * x, z = top(at) - 0.5;
        const Opening arch{at, z - 0.14, z, half};
        moulding(b, {{0, 0}, {0, 0.09}, {0.09, 0.09}, {0.09, 0}}, 16,
                 [&](double t, const Vector2d& p) { return arch.around(t, p); });
    }
}

void front(ModelBuilder& b, double half, double eaves, double ridge) {
    const auto gable = [=](double x) { return ridge - (ridge - eaves) * std::abs(x) / half; };
    const double middle = 0.52 * half, string = 0.78 * eaves;
    const auto flat = [=](double) { return string; };
    const Opening portal{0, 0.3, 0.4 * eaves, 0.23 * half}, rose{0, 0, 1.04 * eaves, 0.15 * half, true};
    pierced_wall(b, -middle, middle, 0, flat, portal.wider(0.84));
    reveal(b, portal, 0.9, 3, 0.28);
    pierced_wall(b, -middle, middle, string, gable, rose.wider(0.36));
    reveal(b, rose, 0.5, 2, 0.18);
    tracery(b, rose, 0.3);
    for (const double side : {-1.0, 1.0}) {
        const double x0 = side > 0 ? middle : -half, x1 = x0 + half - middle;
        const Opening window{side * 0.76 * half, 0.28 * eaves, 0.55 * eaves, 0.07 * half};
        pierced_wall(b, x0, x1, 0, gable, window.wider(0.3));
        reveal(b, window, 0.6, 2, 0.15);
        block(b, {window.x - 0.75, -0.16, window.sill - 0.14}, {window.x + 0.75, 0, window.sill},
              Material::limestone);
        raking_cornice(b, -side * half, gable);
        const double corner = side * (half - 0.22);
        block(b, {corner - 0.3, -0.14, 0}, {corner + 0.3, 0, eaves - 0.3}, Material::ashlar);
        const double in = side * 1.85, out = side * (half + 0.15);
        block(b, {std::min(in, out), -0.2, 0}, {std::max(in, out), 0, 0.55}, Material::limestone);
    }
    moulding(b, {{-0.1, 0}, {-0.06, 0.1}, {0.06, 0.16}, {0.1, 0.16}, {0.12, 0}}, 1,
             [&](double t, const Vector2d& p) {
                 return Vector3d((2 * t - 1) * (half + 0.04), -p.y(), string + p.x());
             });
}

/// The other three walls, with a buttress on each side wall, and the roof.
void shell_of_chapel(ModelBuilder& b, double half, double eaves, double rise, double depth) {
    constexpr double over = 0.3;
    const Vector3d up(0, 0, eaves), back(0, depth, 0);
    for (const double side : {-1.0, 1.0}) {
        b.quad({side * half, side > 0 ? 0 : depth, 0}, side * back, up, Material::ashlar);
        b.box({side * (half + 0.25), 0.35 * depth, 0.35 * eaves}, {0.25, 0.3, 0.35 * eaves},
              Material::ashlar);
        const double out = half + over, low = eaves - rise * over / half + 0.16;
        b.quad({side * out, side > 0 ? -0.1 : depth, low}, side * Vector3d(0, depth + 0.1, 0),
               {-side * out, 0, rise * out / half}, Material::tiles);
    }
    b.quad({half, depth, 0}, {-2 * half, 0, 0}, up, Material::ashlar);
    const auto corner = [&](double x, double z) { return b.vertex({x, depth, z}, Vector3d::UnitY()); };
    b.triangle(corner(half, eaves), corner(-half, eaves), corner(0, eaves + rise), Material::ashlar);
}

/// A stack of blocks with square bases.
void pedestal(ModelBuilder& b, const Vector3d& foot, double size) {
    for (const auto& [low, high, wide] : {std::tuple(0.0, 0.12, 0.62), std::tuple(0.12, 0.24, 0.52),
                                          std::tuple(0.24, 0.92, 0.42), std::tuple(0.92, 1.0, 0.5)})
        block(b, foot + Vector3d(-wide * size, -wide * size, low),
              foot + Vector3d(wide * size, wide * size, high), Material::limestone);
}

}  // namespace

void add_chapel(ModelBuilder& b, const SynthSpec& spec) {
    const double half = spec.building.width / 2, eaves = spec.building.height, rise = 0.66 * half;
    front(b, half, eaves, eaves + rise);
    shell_of_chapel(b, half, eaves, rise, spec.building.depth);
    const double court = 2.8 * half;
    b.quad({-court, -court, 0}, {2 * court, 0, 0}, {0, court, 0}, Material::flags);
    for (const double step : {0.0, 1.0})
        block(b, {-2.5 + 0.4 * step, -1.1 + 0.4 * step, 0.15 * step},
              {2.5 - 0.4 * step, 0, 0.15 + 0.15 * step}, Material::limestone);
    const Vector3d foot(-0.4 * half, -spec.object.distance, 0);
    pedestal(b, foot, spec.object.size);
    add_urn(b, foot + Vector3d::UnitZ(), 1.5 * spec.object.size, spec.object.triangles);
}

}  // namespace vantage
