#include "pipeline/synth/surface_finish.h"

#include <algorithm>
#include <cmath>

#include "pipeline/synth/noise.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// Rises linearly from 0 at `low` to 1 at `high`.
double ramp(double x, double low, double high) { return std::clamp((x - low) / (high - low), 0.0, 1.0); }

Vector3d stretched(const Vector3d& p, double x, double y, double z) {
    return p.cwiseProduct(Vector3d(x, y, z));
}

/// Slope of a height in meters.
template <class Height>
double slope(const SurfacePoint& at, const Height& height) {
    const double step = std::max(at.footprint, 0.002);
    return (height(at.position + step * at.toward) - height(at.position)) / step;
}

/// One of the stones of a wall or a pavement.
struct Stone {
    double id;    ///< [0, 1), random
    double tilt;  ///< height of the stone's slightly tilted face at this point, in meters
    double edge;  ///< distance to the stone's nearest edge, in meters
};

/// The stone at a point; stones of different widths lie in rows of `height`.
Stone stone_at(const Vector2d& p, double height) {
    const double row = std::floor(p.y() / height);
    const auto r = std::int64_t(row);
    const double width = height * (1.4 + 0.9 * hashed(r, 1, 7)), x = p.x() / width + 9 * hashed(r, 2, 7);
    const auto left = [&](double c) { return c + 0.5 * hashed(std::int64_t(c), r, 3); };
    double column = std::floor(x);
    if (x < left(column)) --column;
    const auto c = std::int64_t(column);
    const double l = (x - left(column)) * width, right = (left(column + 1) - x) * width;
    const double low = p.y() - row * height;
    const double tilt = 0.1 * (hashed(c, r, 4) - 0.5) * (l - right) + 0.14 * (hashed(c, r, 5) - 0.5) * low;
    return {hashed(c, r, 6), tilt, std::min({l, right, low, height - low})};
}

/// The color of a weathered surface: darker where it is dirty, gray where lichen grows, and green near the
/// ground.
Vector3f weathered(const Vector3f& clean, const SurfacePoint& at) {
    const Vector3d& p = at.position;
    const double streaks = rough(stretched(p, 1, 1, 0.16), 0.7, 0.04, 0.7);
    const double dirt = 0.42 * ramp(streaks, 0.1, 1.3) + 0.5 * ramp(at.sky, 0.45, 0.05);
    const double spots = rough(p + Vector3d(31, 7, 3), 0.5, std::max(at.footprint, 0.03), 0.8);
    const double damp = ramp(p.z() + 0.4 * spots, 0.7, -0.1);
    Vector3f out = clean * float(1 - 0.62 * std::min(1.0, dirt));
    out = mix(out, {0.40f, 0.39f, 0.33f}, 0.45 * ramp(spots, 0.75, 1.1));
    return mix(out, {0.13f, 0.13f, 0.075f}, 0.55 * damp);
}

Finish ashlar(const SurfacePoint& at) {
    const auto stone = [&](const Vector3d& p, double chipped) {
        Stone s = stone_at(across_and_up(p, at.normal, 0.7), 0.31);
        s.edge -= 0.008 + 0.008 * chipped;
        return s;
    };
    const auto height = [&](const Vector3d& p) {
        const double chisel = rough(p, 0.16, at.footprint, 0.75);
        const Stone s = stone(p, chisel);
        const double bevel = ramp(s.edge, 0.018, 0);
        return s.tilt + 0.008 * chisel - 0.009 * bevel * bevel;
    };
    const double grain = rough(at.position, 0.3, at.footprint, 1.0);
    const Stone s = stone(at.position, grain);
    const double joint = ramp(s.edge, at.footprint / 2, -at.footprint / 2);
    const Vector3f tint = mix(mix({0.62f, 0.50f, 0.34f}, {0.50f, 0.42f, 0.31f}, s.id), {0.58f, 0.40f, 0.26f},
                              ramp(s.id, 0.8, 1));
    const Vector3f face = tint * float((1 + 0.11 * grain - 0.3 * ramp(grain, 1.1, 1.8)) *
                                       (0.82 + 0.3 * std::fmod(7 * s.id, 1.0)));
    return {weathered(mix(face, {0.34f, 0.30f, 0.24f}, joint), at), slope(at, height)};
}

Finish limestone(const SurfacePoint& at) {
    const auto height = [&](const Vector3d& p) { return 0.006 * rough(p, 0.12, at.footprint, 0.7); };
    const double grain = rough(stretched(at.position, 1, 1, 2.5), 0.2, at.footprint, 1.0);
    return {weathered(Vector3f(0.66f, 0.57f, 0.43f) * float(1 + 0.12 * grain), at), slope(at, height)};
}

Finish statuary(const SurfacePoint& at) {
    const Vector3d& p = at.position;
    const double swirl = rough(p, 0.8, 0.03, 0.6);
    const double vein = std::pow(1 - std::abs(std::sin(5 * p.x() + 4 * p.z() + 3.2 * swirl)), 6);
    const double stain = rough(stretched(p, 1, 1, 0.2), 0.25, 0.02, 0.75);
    const double dirt = 0.9 * ramp(at.sky, 0.42, 0.08) + 0.35 * ramp(stain, 0.2, 1.4);
    const Vector3f clean = mix({0.80f, 0.77f, 0.70f}, {0.42f, 0.43f, 0.44f}, 0.6 * vein);
    return {mix(clean, {0.16f, 0.14f, 0.10f}, std::min(0.85, dirt)),
            slope(at, [&](const Vector3d& q) { return 0.0015 * rough(q, 0.05, at.footprint, 0.7); })};
}

/// Planks with iron bands and nails.
Finish wood(const SurfacePoint& at) {
    const Vector3d& p = at.position;
    const double plank = std::floor(p.x() / 0.17), across = p.x() - 0.17 * plank;
    const double gap =
        ramp(std::min(across, 0.17 - across), 0.004 + at.footprint / 2, 0.004 - at.footprint / 2);
    const auto grain = [&](const Vector3d& q) {
        return rough(stretched(q, 1, 1, 0.05) + Vector3d(0, 0, 3 * plank), 0.08, 0.5 * at.footprint, 0.85);
    };
    const double tone = hashed(std::int64_t(plank), 3, 1), fade = ramp(p.z(), 1.1, 0.3);
    Vector3f out = mix({0.13f, 0.075f, 0.04f}, {0.27f, 0.18f, 0.11f}, 0.5 * tone + 0.25 * grain(p) + 0.2);
    out = mix(out, {0.3f, 0.28f, 0.25f}, 0.5 * fade);
    out = mix(out, {0.01f, 0.01f, 0.01f}, gap);
    const double row = p.z() - 0.55 * std::round(p.z() / 0.55), nail = std::hypot(across - 0.085, row);
    const double band = std::fmod(std::round(p.z() / 0.55), 2) == 1 ? std::abs(row) - 0.035 : 1;
    out = mix(out, {0.035f, 0.033f, 0.035f},
              ramp(std::min(band, nail - 0.022), at.footprint / 2, -at.footprint / 2));
    return {out, slope(at, [&](const Vector3d& q) { return 0.004 * grain(q); })};
}

/// Small diamonds of old glass between leads; the room behind them is dark.
Finish leads(const SurfacePoint& at) {
    const Vector2d p(at.position.x(), at.position.z() / 1.4), q(p.x() + p.y(), p.x() - p.y());
    const Vector2d cell = (q / 0.17).array().floor(), in = q - 0.17 * cell;
    const double edge = std::min({in.x(), in.y(), 0.17 - in.x(), 0.17 - in.y()}) / 1.41 - 0.008;
    const double id = hashed(std::int64_t(cell.x()), std::int64_t(cell.y()), 2);
    const Vector3f pane = mix({0.012f, 0.016f, 0.018f}, {0.10f, 0.14f, 0.17f}, id * id * id);
    const double wave = 1 + 0.4 * rough(at.position, 0.1, at.footprint, 0.5);
    return {mix(pane * float(wave), {0.10f, 0.10f, 0.10f}, ramp(edge, at.footprint / 2, -at.footprint / 2)),
            0};
}

Finish tiles(const SurfacePoint& at) {
    const Vector3d& p = at.position;
    const auto height = [&](const Vector3d& q) {
        return 0.04 * std::abs(std::sin(q.y() / 0.2 * 3.14159)) + 0.01 * rough(q, 0.3, at.footprint, 0.6);
    };
    const double id = hashed(std::int64_t(std::floor(p.y() / 0.2)), std::int64_t(std::floor(p.x() / 0.3)), 8);
    const Vector3f clay = mix({0.45f, 0.19f, 0.10f}, {0.60f, 0.36f, 0.22f}, id);
    const double moss = ramp(rough(p, 1.2, at.footprint, 0.7), 0.2, 1);
    return {mix(clay, {0.22f, 0.21f, 0.15f}, 0.8 * moss), slope(at, height)};
}

/// Fields between hedges, and patches of woodland.
Vector3f farmland(const SurfacePoint& at, const Vector3f& grass, const Vector3f& leaves) {
    const Vector3d& p = at.position;
    const double bend = rough(p, 400, 50, 0.5);
    const Stone field = stone_at({p.x() + 0.4 * p.y() + 40 * bend, p.y() - 0.4 * p.x()}, 190);
    const Vector3f crop = mix(mix({0.09f, 0.125f, 0.04f}, {0.19f, 0.17f, 0.075f}, field.id),
                              {0.15f, 0.105f, 0.065f}, ramp(std::fmod(field.id * 7, 1.0), 0.7, 0.75));
    const Vector3f tilled = mix(grass, crop, 0.85);
    const double woods = rough(p + Vector3d(900, 0, 0), 500, at.footprint, 0.6);
    const double hedge = ramp(field.edge, 9, 4) * ramp(rough(p, 30, at.footprint, 0.7), -0.3, 0.2);
    return mix(tilled, leaves, std::max(hedge, ramp(woods, 0.05, 0.1)));
}

/// Meadow nearby and farmland far away.
Finish meadow(const SurfacePoint& at) {
    const Vector3d& p = at.position;
    const double far = p.head<2>().norm(), tufts = rough(p, 1.5, at.footprint, 0.9),
                 dry = rough(p, 24, 2, 0.6);
    const Vector3f grass =
        mix({0.075f, 0.115f, 0.028f}, {0.29f, 0.28f, 0.11f}, 0.42 + 0.16 * tufts + 0.34 * dry);
    if (far > 120) {
        const Vector3f leaves = Vector3f(0.055f, 0.085f, 0.03f) * float(1 + 0.35 * tufts);
        return {mix(grass, farmland(at, grass, leaves), ramp(far, 120, 260)), 0};
    }
    return {grass, ramp(far, 120, 60) * slope(at, [&](const Vector3d& q) {
                       return 0.06 * rough(q, 0.3, at.footprint, 0.65);
                   })};
}

/// Worn slabs with grass in their joints, which gradually give way to the meadow.
Finish flags(const SurfacePoint& at) {
    const Vector3d& p = at.position;
    const auto height = [&](const Vector3d& q) {
        const Stone s = stone_at({q.x(), q.y()}, 0.62);
        const double bevel = ramp(s.edge, 0.05, 0);
        return 0.5 * s.tilt + 0.012 * rough(q, 0.3, at.footprint, 0.6) - 0.02 * bevel * bevel;
    };
    const double grain = rough(p, 0.5, at.footprint, 1.0),
                 patches = rough(p, 2.5, std::max(at.footprint, 0.08), 0.65);
    const Stone s = stone_at({p.x(), p.y()}, 0.62);
    Vector3f out = mix({0.44f, 0.39f, 0.31f}, {0.33f, 0.30f, 0.25f}, s.id) * float(1 + 0.11 * grain);
    out = out * float(1 - 0.3 * ramp(patches, 0.1, 1.2) - 0.35 * ramp(at.sky, 0.85, 0.3));
    const double edge = s.edge - 0.016 - 0.012 * grain;
    out = mix(out, {0.17f, 0.15f, 0.09f}, ramp(edge, at.footprint / 2, -at.footprint / 2));
    const double grown = ramp(0.1 * patches + 0.02 * grain - s.edge, 0, 0.04) +
                         ramp(p.head<2>().norm() + 1.4 * patches, 9.3, 9.7);
    if (!(grown > 0)) return {out, slope(at, height)};
    const Finish grass = meadow(at);
    const double green = std::min(1.0, grown);
    return {mix(out, grass.albedo, green), slope(at, height) * (1 - green) + grass.slope * green};
}

}  // namespace

Finish finish(Material material, const SurfacePoint& at) {
    switch (material) {
        case Material::ashlar:
            return ashlar(at);
        case Material::limestone:
            return limestone(at);
        case Material::statuary:
            return statuary(at);
        case Material::wood:
            return wood(at);
        case Material::leads:
            return leads(at);
        case Material::tiles:
            return tiles(at);
        case Material::flags:
            return flags(at);
        case Material::meadow:
            return meadow(at);
        default:
            return {albedo(material, at.position, at.normal), 0};
    }
}

}  // namespace vantage
