#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "pipeline/background/coarse_view.h"

/// A yard with known depth around a sphere of radius 1.5, which is the only object with a mesh. The yard has
/// level ground, a hill in the shape of a cylinder with radius 25 and height 6, and a sky. The z axis points
/// up.
namespace vantage::yard {

constexpr double hill_radius = 25, hill_height = 6;

/// The distance to the yard along a ray; infinite for the sky.
inline double distance(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) {
    const double ground =
        direction.z() < 0 ? -eye.z() / direction.z() : std::numeric_limits<double>::infinity();
    const Eigen::Vector2d e = eye.head<2>(), d = direction.head<2>();
    const double a = d.squaredNorm(), b = e.dot(d), c = e.squaredNorm() - hill_radius * hill_radius;
    const double hill = (-b + std::sqrt(b * b - a * c)) / a;
    if (ground < hill) return ground;
    return eye.z() + hill * direction.z() < hill_height ? hill : std::numeric_limits<double>::infinity();
}

/// A smooth pattern that does not repeat within a few units.
inline double texture(double x, double y) {
    return 0.5 + 0.2 * std::sin(1.7 * x + 0.6 * std::sin(2.3 * y)) +
           0.2 * std::sin(2.1 * y + 0.9 * std::sin(1.3 * x)) + 0.1 * std::sin(5.1 * x - 4.3 * y);
}

inline Eigen::Array3f color(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) {
    const double r = distance(eye, direction);
    const Eigen::Vector3d p = eye + r * direction;
    if (!std::isfinite(r)) {
        const double clouds = texture(6 * std::atan2(direction.y(), direction.x()), 8 * direction.z());
        return Eigen::Array3f(0.4f, 0.5f, 0.6f) + 0.3f * float(clouds);
    }
    if (p.z() < 1e-6) return Eigen::Array3f(0.5f, 0.4f, 0.3f) * float(texture(p.x(), p.y()));
    return Eigen::Array3f(0.2f, 0.5f, 0.2f) * float(texture(12 * std::atan2(p.y(), p.x()), 0.5 * p.z()));
}

using PlainBackground = std::function<Eigen::Array3f(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray,
                                                     const Eigen::Vector2d& pixel)>;

/// Photos from an arc around the sphere, with the yard or another background.
inline std::vector<CoarseView> photos(const PlainBackground& plain_background) {
    std::vector<CoarseView> out;
    for (int i = 0; i < 9; ++i) {
        CoarseView v;
        v.photo = std::uint32_t(i);
        v.k = {144, 108, 120, 120, 72, 54};
        const double angle = (i - 4) * 12 * std::numbers::pi / 180;
        const Eigen::Vector3d eye(6 * std::sin(angle), -6 * std::cos(angle), 1.6 + 0.1 * (i % 3));
        const Eigen::Vector3d forward = (Eigen::Vector3d(0, 0, 1.2) - eye).normalized();
        const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
        v.pose.R << right.transpose(), forward.cross(right).transpose(), forward.transpose();
        v.pose.t = -v.pose.R * eye;
        for (int y = 0; y < v.k.height; ++y)
            for (int x = 0; x < v.k.width; ++x) {
                const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
                const Eigen::Vector3d ray =
                    (v.pose.R.transpose() *
                     Eigen::Vector3d((pixel.x() - v.k.cx) / v.k.fx, (pixel.y() - v.k.cy) / v.k.fy, 1))
                        .normalized();
                const double along = -eye.dot(ray), miss = (eye + along * ray).norm();
                const bool mesh = miss < 1.5;
                v.z.push_back(mesh ? float(along * ray.dot(forward))
                                   : std::numeric_limits<float>::infinity());
                const Eigen::Array3f unknown =
                    Eigen::Array3f::Constant(std::numeric_limits<float>::quiet_NaN());
                v.ln.push_back(mesh ? unknown : ln_of(plain_background(eye, ray, pixel)));
                ++v.pixels;
                v.open += !mesh;
            }
        out.push_back(std::move(v));
    }
    return out;
}

inline std::vector<CoarseView> photos() {
    return photos([](const auto& eye, const auto& ray, const auto&) { return color(eye, ray); });
}

}  // namespace vantage::yard
