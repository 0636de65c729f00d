#include "pipeline/synth/daylight.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "pipeline/synth/noise.h"
#include "pipeline/synth/surface_finish.h"

namespace vantage {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const Vector3d toward_sun = Vector3d(-0.62, -0.62, 0.52).normalized();
// Light on a white surface that faces the source of the light, relative to white in a photo.
const Vector3f sunlight(1.42f, 1.24f, 0.95f), skylight(0.27f, 0.35f, 0.47f), bounced(0.15f, 0.12f, 0.085f);
const Vector3f horizon(0.72f, 0.80f, 0.88f), haze(0.30f, 0.41f, 0.57f);
constexpr double clear_distance = 9000;  ///< distance in m at which haze leaves 1 / e of the light
constexpr double sun_radius = 0.0047;    ///< rad
constexpr int sky_rays = 32;             ///< per vertex

/// The fraction of the sky that is visible. Rays are spaced by the golden angle around the normal, with
/// cosine-weighted density.
double sky_share(const RayScene& rays, const Vector3d& p, const Vector3d& n) {
    const Vector3d x = n.unitOrthogonal(), y = n.cross(x);
    int seen = 0;
    for (int i = 0; i < sky_rays; ++i) {
        const double r2 = (i + 0.5) / sky_rays, angle = 2.399963 * i;
        const Vector3d d =
            std::sqrt(r2) * (std::cos(angle) * x + std::sin(angle) * y) + std::sqrt(1 - r2) * n;
        seen += d.z() > 0 && !rays.occluded(p + 3e-3 * n, d, 0, 1e4);
    }
    return double(seen) / sky_rays;
}

Vector3d sun_point(double random) {
    const double r = sun_radius * std::sqrt(random),
                 angle = 2 * std::numbers::pi * std::fmod(random * 97, 1.0);
    const Vector3d x = toward_sun.unitOrthogonal();
    return (toward_sun + r * (std::cos(angle) * x + std::sin(angle) * toward_sun.cross(x))).normalized();
}

/// `d` has length 1; `pixel` is the angle subtended by a pixel, in radians.
Vector3f daylight_sky(const Vector3d& d, double pixel) {
    const double up = std::max(0.0, d.z());
    Vector3f sky = mix(horizon, {0.17f, 0.36f, 0.68f}, 1 - std::exp(-2.6 * up));
    sky += Vector3f(0.5f, 0.42f, 0.3f) * float(0.3 * std::pow(std::max(0.0, d.dot(toward_sun)), 6));
    const Vector3d above = 1.6 * d / (up + 0.13);  // on a layer of clouds
    const double width = 1.6 * pixel / ((up + 0.13) * (up + 0.13));
    const auto thick = [&](const Vector3d& p, double finest) {
        return rough({p.x(), 1.5 * p.y(), 0}, 1.7, finest, 0.52);
    };
    const double share = std::clamp(thick(above, width) * 0.9 + 0.3, 0.0, 1.0),
                 soft = share * share * (3 - 2 * share);
    const double bright =
        std::clamp(0.95 + 0.35 * (thick(above, 0.1) - thick(above + 0.15 * toward_sun, 0.1)), 0.6, 1.1);
    return mix(sky, Vector3f(0.95f, 0.94f, 0.92f) * float(bright), 0.7 * soft * std::min(1.0, 5 * up));
}

}  // namespace

void add_daylight(SynthModel& model, const RayScene& rays) {
    for (std::size_t i = 0; i < model.mesh.positions.size(); ++i)
        model.sky.push_back(
            float(sky_share(rays, model.mesh.positions[i], model.mesh.normals[i].cast<double>())));
}

Seen daylight(const SynthModel& model, const RayScene& rays, const Vector3d& eye, const Vector3d& direction,
              double pixel) {
    const auto hit = rays.first_hit(eye, direction);
    if (!hit) return {.light = daylight_sky(direction, pixel)};
    const auto& t = model.mesh.triangles[hit->triangle];
    const Vector3d share(1 - hit->uv.sum(), hit->uv.x(), hit->uv.y());
    SurfacePoint at{eye + hit->distance * direction, Vector3d::Zero(), Vector3d::Zero(), 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        at.normal += share[Eigen::Index(i)] * model.mesh.normals[t[i]].cast<double>();
        at.sky += share[Eigen::Index(i)] * double(model.sky[t[i]]);
    }
    const Vector3d n = at.normal = at.normal.normalized();
    const double height = n.dot(toward_sun), along = std::sqrt(1 - height * height);
    at.toward = (toward_sun - n * height).normalized();
    at.footprint = hit->distance * pixel / std::sqrt(std::max(0.1, std::abs(n.dot(direction))));
    const Material material = model.materials[hit->triangle];
    const Finish f = finish(material, at);
    const double facing = height - std::clamp(f.slope, -1.0, 1.0) * along;
    const auto bits = [](double x) { return std::int64_t(x * 1e5); };
    const Vector3d sun =
        sun_point(hashed(bits(at.position.x()), bits(at.position.y()), bits(at.position.z())));
    const bool lit = height > 0 && !rays.occluded(at.position + 4e-3 * n, sun, 0, 1e4);
    const Vector3f light = (lit ? std::max(0.0f, float(facing)) : 0.0f) * sunlight +
                           float(at.sky) * skylight + float(1 - at.sky) * bounced;
    return {mix(haze, f.albedo.cwiseProduct(light), std::exp(-hit->distance / clear_distance)),
            at.position.cast<float>(), n.cast<float>(), 1 + 2 * int(material) + lit};
}

bool same_surface(const Seen& a, const Seen& b) {
    const float contrast = std::abs(a.light.sum() - b.light.sum()) / (a.light.sum() + b.light.sum() + 0.1f);
    if (a.kind != b.kind || contrast > 0.2f) return false;
    return a.kind == 0 ||
           (a.normal.dot(b.normal) > 0.97f && std::abs(a.normal.dot(a.position - b.position)) < 0.03f);
}

}  // namespace vantage
