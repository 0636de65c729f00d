#include "pipeline/synth/cast_photo.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "pipeline/synth/daylight.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// The inverse of distort() by Newton's method; nullopt where the lens model is not invertible.
std::optional<Vector2d> undistort_point(const Lens& lens, const Vector2d& distorted) {
    Vector2d x = distorted;
    for (int i = 0; i < 30; ++i) {
        const Vector2d error = distort(lens, x) - distorted;
        if (error.norm() < 1e-12) return x;
        const double h = 1e-6;
        Eigen::Matrix2d J;
        J.col(0) = (distort(lens, x + Vector2d(h, 0)) - distort(lens, x - Vector2d(h, 0))) / (2 * h);
        J.col(1) = (distort(lens, x + Vector2d(0, h)) - distort(lens, x - Vector2d(0, h))) / (2 * h);
        if (!(J.determinant() > 1e-3)) return std::nullopt;
        x -= J.inverse() * error;
    }
    return (distort(lens, x) - distorted).norm() < 1e-9 ? std::optional(x) : std::nullopt;
}

/// The model, lit by the sun and the sky.
struct LitScene {
    const SynthModel& model;
    const RayScene& rays;
    SynthImageSet image_set;

    Vector3d normal(const RayHit& hit) const {
        const auto& t = model.mesh.triangles[hit.triangle];
        const auto n = [&](std::size_t i) { return model.mesh.normals[t[i]].cast<double>(); };
        return (n(0) * (1 - hit.uv.sum()) + n(1) * hit.uv.x() + n(2) * hit.uv.y()).normalized();
    }
    /// Linear light that arrives along the ray from the first surface that it hits, or from the sky.
    Vector3f color(const Vector3d& eye, const Vector3d& direction) const {
        const auto hit = rays.first_hit(eye, direction);
        if (!hit) {
            const Vector3d d = direction.normalized();
            const double up = std::clamp(d.z() * 2, 0.0, 1.0);
            const Vector3f sky =
                Vector3f(0.60f, 0.72f, 0.86f) * float(1 - up) + Vector3f(0.16f, 0.34f, 0.70f) * float(up);
            const Vector3f shown = model.clouds ? clouded(sky, d) : sky;
            return image_set == SynthImageSet::visible ? shown
                                                       : Vector3f(Vector3f::Constant(0.15f * shown.x()));
        }
        const Vector3d p = eye + hit->distance * direction, n = normal(*hit);
        const Vector3d sun = Vector3d(-0.55, -0.75, 0.62).normalized();
        const double facing = n.dot(sun);
        const bool lit = facing > 0 && !rays.occluded(p + n * 2e-3, sun, 0, 1e6);
        const double sky = 0.34 * (0.65 + 0.35 * n.z());
        const Material material = model.materials[hit->triangle];
        const Vector3f reflected =
            image_set == SynthImageSet::visible ? albedo(material, p, n) : infrared_albedo(material, p, n);
        return reflected * float(sky + (lit ? 0.85 * facing : 0.0));
    }
};

/// The sRGB byte of linear light.
std::uint8_t encode(float linear) {
    const float l = std::clamp(linear, 0.0f, 1.0f);
    const float s = l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1 / 2.4f) - 0.055f;
    return std::uint8_t(std::lround(255 * s));
}

/// The ray through the point (u, v) of the photo, in pixels; its z in camera coordinates is 1.
std::optional<Vector3d> ray_through(const Camera& camera, double u, double v) {
    const Intrinsics& k = camera.intrinsics;
    const Vector2d p((u - k.cx) / k.fx, (v - k.cy) / k.fy);
    const auto ray = camera.lens.distorts() ? undistort_point(camera.lens, p) : std::optional(p);
    if (!ray) return std::nullopt;
    return camera.cam_from_world.R.transpose() * Vector3d(ray->x(), ray->y(), 1);
}

/// Mean of samples x samples rays through a pixel; invalid rays count as 0.
template <class Light>
Vector3f pixel_mean(const Camera& camera, int x, int y, int samples, const Light& light) {
    Vector3f sum = Vector3f::Zero();
    for (int s = 0; s < samples * samples; ++s) {
        const auto ray =
            ray_through(camera, x + (s % samples + 0.5) / samples, y + (s / samples + 0.5) / samples);
        if (ray) sum += light(*ray);
    }
    return sum / float(samples * samples);
}

/// Linear light per pixel in daylight, from one ray per pixel, or from samples x samples rays at edges.
std::vector<Vector3f> cast_daylight(const SynthModel& model, const RayScene& rays, const Camera& camera,
                                    int samples) {
    const int width = camera.intrinsics.width, height = camera.intrinsics.height;
    const auto seen = [&](const Vector3d& ray) {
        return daylight(model, rays, camera.cam_from_world.center(), ray.normalized(),
                        1 / camera.intrinsics.fx);
    };
    std::vector<Seen> middle(std::size_t(width) * std::size_t(height));
    const auto at = [&](int x, int y) -> Seen& {
        return middle[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (const auto ray = ray_through(camera, x + 0.5, y + 0.5)) at(x, y) = seen(*ray);
    std::vector<Vector3f> out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto joined = [&](int i, int j) {
                return same_surface(at(x, y),
                                    at(std::clamp(x + i, 0, width - 1), std::clamp(y + j, 0, height - 1)));
            };
            const bool inside = joined(-1, 0) && joined(1, 0) && joined(0, -1) && joined(0, 1);
            out.push_back(inside ? at(x, y).light : pixel_mean(camera, x, y, samples, [&](const Vector3d& r) {
                return seen(r).light;
            }));
        }
    return out;
}

}  // namespace

std::vector<std::uint8_t> cast_photo(const SynthModel& model, const RayScene& rays, const Camera& camera,
                                     int samples, const PhotoExposure& exposure, SynthImageSet image_set) {
    const LitScene scene{model, rays, image_set};
    const Intrinsics& k = camera.intrinsics;
    const Vector3d eye = camera.cam_from_world.center();
    const bool plain = model.sky.empty();
    const auto daylit = plain ? std::vector<Vector3f>() : cast_daylight(model, rays, camera, samples);
    const double half_diagonal = 0.5 * std::hypot(k.width, k.height),
                 a = 1 / std::sqrt(1 - exposure.vignetting) - 1;
    std::vector<std::uint8_t> rgb;
    rgb.reserve(std::size_t(k.width) * std::size_t(k.height) * 3);
    for (int y = 0; y < k.height; ++y)
        for (int x = 0; x < k.width; ++x) {
            const Vector3f mean = plain ? pixel_mean(camera, x, y, samples,
                                                     [&](const Vector3d& r) { return scene.color(eye, r); })
                                        : daylit[rgb.size() / 3];
            const double r = std::hypot(x + 0.5 - k.cx, y + 0.5 - k.cy) / half_diagonal;
            const double light = 1 / std::pow(1 + a * r * r, 2);
            for (std::size_t c = 0; c < 3; ++c)
                rgb.push_back(encode(mean[Eigen::Index(c)] * float(light * exposure.gain[c])));
        }
    return rgb;
}

std::vector<float> cast_depth(const RayScene& rays, const Camera& camera) {
    const Intrinsics& k = camera.intrinsics;
    const Eigen::Matrix3d world_from_cam = camera.cam_from_world.R.transpose();
    std::vector<float> z;
    z.reserve(std::size_t(k.width) * std::size_t(k.height));
    for (int y = 0; y < k.height; ++y)
        for (int x = 0; x < k.width; ++x) {
            const Vector3d ray((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
            const auto hit = rays.first_hit(camera.cam_from_world.center(), world_from_cam * ray);
            z.push_back(hit ? float(hit->distance) : std::numeric_limits<float>::infinity());
        }
    return z;
}

}  // namespace vantage
