#include "pipeline/refine/poses/pose_fit.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <cmath>

namespace vantage {
namespace {

/// Reprojection error, in px, of a track's point in one photo.
struct ReprojectionError {
    const FittedCamera& camera;
    Eigen::Vector3d point, right, down;  ///< `right` and `down` are tangents, one pixel long
    Eigen::Vector2d pixel;

    template <class T>
    bool operator()(const T* change, const T* slide, T* residual) const {
        const Eigen::Matrix<T, 3, 1> x =
            point.cast<T>() + right.cast<T>() * slide[0] + down.cast<T>() * slide[1];
        const Eigen::Matrix<T, 3, 1> before = camera.given.R.cast<T>() * x + camera.given.t.cast<T>();
        const double f = std::sqrt(camera.k.fx * camera.k.fy);
        const T turn[3] = {change[0] / f, change[1] / f, change[2] / f};
        T p[3];
        ceres::AngleAxisRotatePoint(turn, before.data(), p);
        for (int i = 0; i < 3; ++i) p[i] += change[3 + i] * (camera.distance / f);
        if (!(p[2] > T(0))) return false;
        residual[0] = camera.k.fx * p[0] / p[2] + camera.k.cx - pixel.x();
        residual[1] = camera.k.fy * p[1] / p[2] + camera.k.cy - pixel.y();
        return true;
    }
};

/// A prior that pulls a camera toward its given pose.
struct Anchor {
    double weight;
    template <class T>
    bool operator()(const T* change, T* residual) const {
        for (int i = 0; i < 6; ++i) residual[i] = change[i] * weight;
        return true;
    }
};

void add_track(ceres::Problem& problem, std::span<const FittedCamera> cameras, const Track& track,
               double* slide, ceres::LossFunction* loss, std::vector<PoseChange>& change) {
    const FittedCamera& own = cameras[track.photo];
    const double pixel = (own.given.R * track.point + own.given.t).norm() / std::sqrt(own.k.fx * own.k.fy);
    const Eigen::Vector3d right = track.normal.unitOrthogonal() * pixel, down = track.normal.cross(right);
    const auto add = [&](std::uint32_t photo, const Eigen::Vector2d& at) {
        using Cost = ceres::AutoDiffCostFunction<ReprojectionError, 2, 6, 2>;
        problem.AddResidualBlock(
            new Cost(new ReprojectionError{cameras[photo], track.point, right, down, at}), loss,
            change[photo].data(), slide);
    };
    add(track.photo, track.pixel);
    for (const Match& m : track.matches) add(m.photo, m.pixel);
}

/// The track, restricted to matches whose residual is finite with `poses`. All matches are dropped if the
/// residual in the track's own photo or the track's normal is not finite.
Track usable(const Track& track, std::span<const FittedCamera> cameras, std::span<const Pose> poses) {
    Track out = track;
    const auto finite = [&](std::uint32_t photo, const Eigen::Vector2d& pixel) {
        const auto seen = project(cameras[photo].k, poses[photo], track.point);
        return seen && std::isfinite((seen->pixel - pixel).squaredNorm());
    };
    std::erase_if(out.matches, [&](const Match& m) { return !finite(m.photo, m.pixel); });
    if (!finite(track.photo, track.pixel) || !track.normal.allFinite()) out.matches.clear();
    return out;
}

}  // namespace

Pose apply_change(const FittedCamera& camera, const PoseChange& c) {
    const double f = std::sqrt(camera.k.fx * camera.k.fy);
    const Eigen::Vector3d turn = Eigen::Vector3d(c[0], c[1], c[2]) / f;
    Eigen::Matrix3d R;
    ceres::AngleAxisToRotationMatrix(turn.data(), R.data());
    return {R * camera.given.R,
            R * camera.given.t + Eigen::Vector3d(c[3], c[4], c[5]) * (camera.distance / f)};
}

PoseFit fit_poses(std::span<const FittedCamera> cameras, std::span<const Track> tracks, double anchor,
                  double sigma, std::vector<PoseChange>& change) {
    ceres::CauchyLoss loss(1.0);
    ceres::Problem::Options ownership;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    std::vector<std::array<double, 2>> slides(tracks.size(), {0, 0});
    std::vector<PoseChange> found = change;
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < cameras.size(); ++i) poses.push_back(apply_change(cameras[i], change[i]));
    for (std::size_t s = 0; s < tracks.size(); ++s) {
        const Track track = usable(tracks[s], cameras, poses);
        if (track.matches.empty()) continue;
        add_track(problem, cameras, track, slides[s].data(), &loss, found);
        order->AddElementToGroup(slides[s].data(), 0);
    }
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (!problem.HasParameterBlock(found[i].data())) continue;
        order->AddElementToGroup(found[i].data(), 1);
        using Cost = ceres::AutoDiffCostFunction<Anchor, 6, 6>;
        problem.AddResidualBlock(new Cost(new Anchor{std::sqrt(anchor) / sigma}), nullptr, found[i].data());
        if (cameras[i].fixed) problem.SetParameterBlockConstant(found[i].data());
    }
    if (problem.NumResidualBlocks() == 0) return {};
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_SCHUR;
    options.linear_solver_ordering = order;
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-9;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;  // a fixed order of summation, so that results are reproducible
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable()) return {};
    change = std::move(found);  // Ceres never returns a higher cost
    return {summary.initial_cost, summary.final_cost, true};
}

}  // namespace vantage
