#include "player/plan/selection/sampling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vantage {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The cone's axis, and normals on its rim and halfway to it.
std::array<Eigen::Vector3d, 9> normals_of(const package::ClusterRecord& c) {
    const Eigen::Vector3d axis(c.cone_axis[0], c.cone_axis[1], c.cone_axis[2]);
    const Eigen::Vector3d side = axis.unitOrthogonal(), other = axis.cross(side);
    const double sine = std::clamp(double(c.cone_cutoff), 0.0, 1.0), cosine = std::sqrt(1 - sine * sine),
                 half_sine = std::sqrt((1 - cosine) / 2), half_cosine = std::sqrt((1 + cosine) / 2);
    constexpr double diagonal = 1 / std::numbers::sqrt2;
    std::array<Eigen::Vector3d, 9> out{axis};
    const std::array<Eigen::Vector3d, 4> around{diagonal * (side + other), other, diagonal * (other - side),
                                                -side};
    for (std::size_t i = 0; i < around.size(); ++i) {
        const bool rim = i % 2 == 0;
        const Eigen::Vector3d middle = (rim ? cosine : half_cosine) * axis,
                              off = (rim ? sine : half_sine) * around[i];
        out[1 + i] = middle + off;
        out[5 + i] = middle - off;
    }
    return out;
}

}  // namespace

std::optional<SurfaceSample> surface_sample(const View& view, const Eigen::Vector3d& position,
                                            const Eigen::Vector3d& normal, double samples) {
    const Eigen::Matrix3d& R = view.cam_from_origin.R;
    const Eigen::Vector3d p = R * position + view.cam_from_origin.t, n = R * normal, ray = p / p.z();
    const double facing = n.dot(ray);
    if (!(p.z() > 0) || !(std::abs(facing) > 1e-9)) return {};
    // The point on the plane at the next sample, minus the point at this sample.
    const auto along = [&](int axis, double f) -> Eigen::Vector3d {
        return R.transpose() *
               ((Eigen::Vector3d::Unit(axis) - ray * (n[axis] / facing)) * (p.z() / (f * samples)));
    };
    return SurfaceSample{position, along(0, view.intrinsics.fx), along(1, view.intrinsics.fy)};
}

double level_of_detail(const SurfaceSample& s, const Intrinsics& k, const Pose& pose) {
    const Eigen::Vector3d q = pose.R * s.position + pose.t;
    const auto length = [&](const Eigen::Vector3d& along) {
        const Eigen::Vector3d step = pose.R * along;
        return Eigen::Vector2d(k.fx * (step.x() - q.x() / q.z() * step.z()),
                               k.fy * (step.y() - q.y() / q.z() * step.z()))
                   .norm() /
               q.z();
    };
    const double a = length(s.along_x), b = length(s.along_y);
    return std::log2(std::max({std::min(a, b), std::max(a, b) / 4, 1e-6}));
}

LevelRange sampled_levels(const package::ClusterRecord& c, const Intrinsics& photo, const Pose& photo_pose,
                          const View& view, double samples) {
    const Eigen::Vector3d center(c.center[0], c.center[1], c.center[2]);
    const Pose& view_pose = view.cam_from_origin;
    const Eigen::Vector3d p = view_pose.R * center + view_pose.t, q = photo_pose.R * center + photo_pose.t;
    if (!(p.z() > c.radius) || !(q.z() > c.radius)) return {0, infinity};
    // Depth varies across the sphere, and so does the scale.
    const double across = std::log2((1 + c.radius / p.z()) * (1 + c.radius / q.z()));
    const double head_on = std::log2(photo.fx / q.z() * p.z() / (view.intrinsics.fx * samples));
    const Eigen::Vector3d sight = view_pose.R.transpose() * p.normalized(),
                          ray = photo_pose.R.transpose() * q.normalized();
    double finest = infinity, coarsest = -infinity;
    for (const Eigen::Vector3d& normal : normals_of(c)) {
        // Only considers normals for which the viewer and the photo see the same side.
        if (c.cone_cutoff >= 1 || normal.dot(sight) * normal.dot(ray) <= 1e-6) continue;
        const auto sample = surface_sample(view, center, normal, samples);
        const double lod = sample ? level_of_detail(*sample, photo, photo_pose) : head_on;
        finest = std::min(finest, lod);
        coarsest = std::max(coarsest, lod);
    }
    if (finest > coarsest) finest = coarsest = head_on;  // any normal, or edge-on
    if (c.cone_cutoff >= 1) finest -= 1, coarsest += 2;
    // A surface tilted by more than 60 degrees in the photo has little detail at finer levels.
    finest = std::max(finest, head_on - 1);
    return {std::max(0.0, finest - across), std::max(0.0, coarsest + across)};
}

}  // namespace vantage
