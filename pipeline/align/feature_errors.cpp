#include "pipeline/align/feature_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "pipeline/align/photo_rays.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Eigen::Matrix3d cross(const Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// The epipolar distance in pixels of photo b, as measured near the center of its lens.
double epipolar_distance(const Camera& a, const Camera& b, const Vector2d& in_a, const Vector2d& in_b) {
    const Pose &p = a.cam_from_world, &q = b.cam_from_world;
    const Eigen::Matrix3d R = q.R * p.R.transpose();
    const Vector3d t = q.t - R * p.t;
    const Vector3d line = cross(t) * R * in_a.homogeneous();
    const double slope = line.head<2>().norm();
    if (!(slope > 0)) return no_error;
    return std::abs(in_b.homogeneous().dot(line)) / slope * std::max(b.intrinsics.fx, b.intrinsics.fy);
}

}  // namespace

std::vector<double> epipolar_errors(std::span<const SharedFeature> features,
                                    std::span<const Camera> cameras) {
    PhotoRays rays(cameras);
    std::vector<double> out;
    for (const SharedFeature& f : features) {
        const auto a = rays.pinhole(f.a, f.in_a), b = rays.pinhole(f.b, f.in_b);
        const Camera& to = cameras[f.b];
        out.push_back(a && b ? epipolar_distance(cameras[f.a], to, *a, *b) / longer_side(to) : no_error);
    }
    return out;
}

std::vector<SharedFeature> agreeing_features(std::span<const SharedFeature> features,
                                             std::span<const Camera> cameras, double most) {
    const std::vector<double> errors = epipolar_errors(features, cameras);
    std::vector<SharedFeature> out;
    for (std::size_t i = 0; i < features.size(); ++i)
        if (errors[i] <= most) out.push_back(features[i]);
    return out;
}

std::vector<SharedFeature> features_with_parallax(std::span<const SharedFeature> features,
                                                  std::span<const Camera> cameras, double least) {
    PhotoRays rays(cameras);
    std::vector<SharedFeature> out;
    for (const SharedFeature& f : features) {
        const auto in_a = rays.pinhole(f.a, f.in_a);
        if (!in_a) continue;
        Camera to = cameras[f.b];
        to.cam_from_world.t.setZero();
        const auto far = imaged(to, cameras[f.a].cam_from_world.R.transpose() * in_a->homogeneous());
        if (!far || (*far - f.in_b).norm() >= least * longer_side(to)) out.push_back(f);
    }
    return out;
}

CastMesh cast_mesh(const Mesh& mesh) {
    MainBox box = main_box(mesh);
    const Vector3d origin = (box.low + box.high) / 2;
    std::vector<Eigen::Vector3f> positions;
    positions.reserve(mesh.positions.size());
    for (const Vector3d& p : mesh.positions) positions.push_back((p - origin).cast<float>());
    return {std::move(box), origin,
            RayScene(positions, {mesh.triangles.front().data(), 3 * mesh.triangles.size()})};
}

std::vector<double> surface_errors(std::span<const SharedFeature> features, std::span<const Camera> cameras,
                                   const CastMesh& mesh) {
    PhotoRays rays(cameras);
    std::vector<double> out;
    for (const SharedFeature& f : features) {
        out.push_back(no_error);
        const auto in_a = rays.pinhole(f.a, f.in_a);
        if (!in_a) continue;
        const Pose& pose = cameras[f.a].cam_from_world;
        const Vector3d eye = pose.center() - mesh.origin;
        const Vector3d along = pose.R.transpose() * in_a->homogeneous();
        const auto hit = mesh.rays.first_hit(eye, along);
        if (!hit) continue;
        const Camera& to = cameras[f.b];
        const auto seen = imaged(to, eye + hit->distance * along + mesh.origin);
        if (seen) out.back() = (*seen - f.in_b).norm() / longer_side(to);
    }
    return out;
}

}  // namespace vantage
