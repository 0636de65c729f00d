#include "pipeline/align/feature_points.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>

#include "pipeline/align/photo_rays.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

const double least_sine = std::sin(2 * std::numbers::pi / 180);

struct Ray {
    Vector3d eye, along;  ///< `along` has unit length
};

std::optional<Ray> ray_of(PhotoRays& rays, std::span<const Camera> cameras, std::uint32_t photo,
                          const Eigen::Vector2d& pixel) {
    const auto p = rays.pinhole(photo, pixel);
    if (!p) return {};
    const Pose& pose = cameras[photo].cam_from_world;
    return Ray{pose.center(), (pose.R.transpose() * p->homogeneous()).normalized()};
}

/// Distances along two rays to their points of closest approach; empty if they are nearly parallel.
std::optional<Eigen::Vector2d> closest(const Ray& a, const Ray& b) {
    const Vector3d between = b.eye - a.eye;
    const double cosine = a.along.dot(b.along), sine2 = a.along.cross(b.along).squaredNorm();
    if (!(sine2 >= least_sine * least_sine)) return {};
    const double on_a = between.dot(a.along), on_b = between.dot(b.along);
    return Eigen::Vector2d(on_a - cosine * on_b, cosine * on_a - on_b) / sine2;
}

}  // namespace

std::vector<FeaturePoint> feature_points(std::span<const SharedFeature> features,
                                         std::span<const Camera> cameras, double pixel) {
    PhotoRays rays(cameras);
    std::vector<FeaturePoint> out;
    for (std::size_t i = 0; i < features.size(); ++i) {
        const SharedFeature& f = features[i];
        const auto a = ray_of(rays, cameras, f.a, f.in_a), b = ray_of(rays, cameras, f.b, f.in_b);
        if (!a || !b) continue;
        const auto at = closest(*a, *b);
        if (!at || !(at->minCoeff() > 0)) continue;
        const double across = at->x() * pixel / cameras[f.a].intrinsics.fx;
        const double sine = a->along.cross(b->along).norm();
        out.push_back({i, (a->eye + at->x() * a->along + b->eye + at->y() * b->along) / 2, a->along, across,
                       across / sine});
    }
    return out;
}

}  // namespace vantage
