#include "pipeline/surroundings/down_direction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "values/principal_axes.h"

namespace vantage {
namespace {

constexpr double least_upright = 0.2;  ///< share of the discs on walls and floors
constexpr double farthest = 0.966;     ///< cosine between both directions, 15 degrees
/// Weight of `held` per disc: where all walls face one way, it decides which way along them is down.
constexpr double held_weight = 0.002;

Eigen::Vector3d turned_toward(const Eigen::Vector3d& direction, const Eigen::Vector3d& other) {
    return direction.dot(other) < 0 ? Eigen::Vector3d(-direction) : direction;
}

}  // namespace

Eigen::Vector3d down_direction(std::span<const Pose> poses) {
    Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
    Eigen::Vector3d columns = Eigen::Vector3d::Zero();
    for (const Pose& pose : poses) {
        const Eigen::Vector3d x = pose.R.row(0).transpose();
        rows += x * x.transpose();
        columns += pose.R.row(1).transpose();
    }
    const PrincipalAxes right = principal_axes(rows);
    const Eigen::Vector3d mean =
        columns.norm() > 1e-9 ? Eigen::Vector3d(columns.normalized()) : Eigen::Vector3d::UnitY();
    if (right.values[0] > 0.2 * right.values[1]) return mean;
    return turned_toward(right.axes.col(0), mean);
}

Eigen::Vector3d down_direction(std::span<const CoarseView> views) {
    std::vector<Pose> poses;
    for (const CoarseView& v : views) poses.push_back(v.pose);
    return down_direction(poses);
}

std::optional<Eigen::Vector3d> down_direction(std::span<const SurfaceDisc> discs,
                                              const Eigen::Vector3d& held) {
    const auto usable = [](const SurfaceDisc& d) { return d.normal.squaredNorm() > 0; };
    Eigen::Vector3d down = held;
    std::size_t upright = 0;
    // Ever closer to a wall or a floor, in sines of the angle.
    for (const double near : {0.3, 0.2, 0.15, 0.1, 0.1, 0.07, 0.07, 0.07}) {
        Eigen::Matrix3d scatter = -held_weight * double(discs.size()) * held * held.transpose();
        upright = 0;
        for (const SurfaceDisc& d : discs) {
            if (!usable(d)) continue;
            const Eigen::Vector3d n = d.normal.cast<double>();
            const double along = std::abs(n.dot(down));
            const bool wall = along<near, floor = along> std::sqrt(1 - near * near);
            if (!wall && !floor) continue;
            scatter += (wall ? 1 : -1) * n * n.transpose();
            ++upright;
        }
        down = turned_toward(principal_axes(scatter).axes.col(0), down);
    }
    const double least = least_upright * double(std::ranges::count_if(discs, usable));
    if (double(upright) < least || down.dot(held) < farthest) return std::nullopt;
    return down;
}

}  // namespace vantage
