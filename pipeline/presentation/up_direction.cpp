#include "pipeline/presentation/up_direction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/values/angle_between.h"
#include "base/values/principal_axes.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double radians = std::numbers::pi / 180;
constexpr double usual_roll = 1.5 * radians;
constexpr double outlier = 12 * radians;     ///< maximum roll; larger rolls are clamped
constexpr double on_its_side = 6 * radians;  ///< roll assumed for a camera on its side
constexpr double leaning = 9 * radians;      ///< typical angle between the photos' mean and the up direction
constexpr double within = 3;                 ///< standard errors
constexpr double farthest_axis = 10 * radians;
constexpr double least_roll = 0.75 * radians;
constexpr std::size_t max_compared = 32;  ///< maximum number of cameras whose pairs propose a direction

constexpr double error_of_surface = 0.7 * radians, farthest_surface = 15 * radians;
constexpr double least_upright = 0.2;  ///< fraction of the discs on walls and floors
constexpr double unsure = 5 * radians, turn_by = 10 * radians;
constexpr double clearly_more = 0.25;  ///< minimum increase of the fraction of discs on walls and floors
/// Weight of `held` per disc. If all walls are parallel, `held` determines which direction parallel to them
/// is up.
constexpr double held_weight = 0.002;

/// The camera axis that should be level if `up` is correct, and its deviation from level in radians.
struct Level {
    Vector3d axis;
    double roll;
};

Level level_axis(const Pose& pose, const Vector3d& up) {
    const Vector3d x = pose.R.row(0), y = pose.R.row(1);
    const double upright = std::abs(x.dot(up)), turned = std::hypot(y.dot(up), on_its_side);
    // If the camera is held upright, its columns run downward.
    const bool headlong = y.dot(up) > outlier;
    if (!headlong && upright <= turned) return {x, upright};
    if (turned < outlier) return {y, turned};
    return {x, headlong ? outlier : upright};
}

/// The misfit of an up direction, a sum over the cameras. Summation stops when the sum reaches `enough`.
double misfit(std::span<const Pose> poses, const Vector3d& up,
              double enough = std::numeric_limits<double>::infinity()) {
    double sum = 0;
    for (std::size_t i = 0; i < poses.size() && sum < enough; ++i)
        sum += std::pow(std::min(level_axis(poses[i], up).roll, outlier), 2);
    return sum;
}

/// The best among `mean` and the directions proposed by pairs of cameras.
Vector3d best_suggestion(std::span<const Pose> poses, const Vector3d& mean) {
    const std::size_t count = std::min(poses.size(), max_compared);
    const auto some = [&](std::size_t i) -> const Pose& { return poses[i * poses.size() / count]; };
    Vector3d best = mean;
    double least = misfit(poses, mean);
    const auto suggest = [&](const Vector3d& direction) {
        if (!(direction.norm() > std::sin(5 * radians))) return;
        for (const Vector3d& up : {Vector3d(direction.normalized()), Vector3d(-direction.normalized())})
            if (const double of = misfit(poses, up, least); of < least) best = up, least = of;
    };
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (const int a : {0, 1})
                suggest(some(i).R.row(a).transpose().cross(some(j).R.row(a).transpose()));
    return best;
}

Vector3d turned_toward(const Vector3d& direction, const Vector3d& other) {
    return direction.dot(other) < 0 ? Vector3d(-direction) : direction;
}

/// Robust least squares near `up`; with parallel rows, `mean` resolves the ambiguity.
UpEstimate refined(std::span<const Pose> poses, Vector3d up, const Vector3d& mean) {
    UpEstimate out{up, leaning};
    for (int round = 0; round < 40; ++round) {  // converges from any proposal
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        double weights = 0, squares = 0;
        for (const Pose& p : poses) {
            const Level level = level_axis(p, up);
            const double roll = level.axis.dot(up), weight = 1 / (1 + std::pow(level.roll / usual_roll, 2));
            scatter += weight * level.axis * level.axis.transpose();
            weights += weight;
            squares += weight * roll * roll;
        }
        const double roll = std::max(std::sqrt(squares / std::max(weights, 1e-9)), least_roll);
        const double trust = std::pow(roll / leaning, 2);
        scatter += trust * (Eigen::Matrix3d::Identity() - mean * mean.transpose());
        const PrincipalAxes axes = principal_axes(scatter);
        up = turned_toward(axes.axes.col(0), up);
        out = {up, roll / std::sqrt(std::max(axes.values[1] - axes.values[0], 1e-12))};
    }
    return out;
}

/// The mean of the photos' up directions, taken from their columns. If the mean vanishes, this is the
/// direction opposite to the mean viewing direction, because cameras look down more often than up.
Vector3d mean_up(std::span<const Pose> poses) {
    Vector3d columns = Vector3d::Zero(), ahead = Vector3d::Zero();
    for (const Pose& p : poses) columns -= p.R.row(1).transpose(), ahead += p.direction();
    for (const Vector3d& sum : {columns, Vector3d(-ahead)})
        if (sum.norm() > 1e-3 * double(poses.size())) return sum.normalized();
    return Vector3d::UnitZ();
}

/// A direction parallel to walls and perpendicular to floors, and the fraction of discs that lie on walls or
/// floors. The fraction is 0 if the direction is not near the requested one.
struct Upright {
    Vector3d up;
    double share;
};

Upright upright_near(std::span<const SurfaceDisc> discs, const Vector3d& held) {
    const auto usable = [](const SurfaceDisc& d) { return d.normal.squaredNorm() > 0; };
    const auto all = double(std::ranges::count_if(discs, usable));
    Upright out{held, 0};
    // Sines of the angles within which a disc counts as wall or floor. The angles decrease from round to
    // round.
    for (const double near : {0.3, 0.2, 0.15, 0.1, 0.1, 0.07, 0.07, 0.07}) {
        Eigen::Matrix3d scatter = -held_weight * all * held * held.transpose();
        double upright = 0;
        for (const SurfaceDisc& d : discs) {
            if (!usable(d)) continue;
            const Vector3d n = d.normal.cast<double>();
            const double along = std::abs(n.dot(out.up));
            const bool wall = along<near, floor = along> std::sqrt(1 - near * near);
            if (!wall && !floor) continue;
            scatter += (wall ? 1 : -1) * n * n.transpose();
            ++upright;
        }
        if (!(upright > 0)) return {held, 0};
        out = {turned_toward(principal_axes(scatter).axes.col(0), out.up), upright / all};
    }
    if (angle_between(out.up, held) > farthest_surface) out.share = 0;
    return out;
}

/// If all cameras look down in the same direction, as in aerial photos, their rows are parallel and their
/// columns are far from vertical. In this case, the estimate is turned about the rows to a direction that has
/// clearly more walls and floors.
Vector3d tilted(std::span<const Pose> poses, const UpEstimate& e, std::span<const SurfaceDisc> discs) {
    if (poses.empty() || e.error < unsure) return e.up;
    Vector3d row = Vector3d::Zero();
    for (const Pose& p : poses) row += turned_toward(p.R.row(0), poses[0].R.row(0));
    Upright best = upright_near(discs, e.up);
    const double near = best.share;
    for (int step = 1; step <= 7; ++step) {
        const Vector3d up = Eigen::AngleAxisd(step * turn_by, row.normalized()) * e.up,
                       down = Eigen::AngleAxisd(-step * turn_by, row.normalized()) * e.up;
        double ahead = 0;
        for (const Pose& p : poses) ahead += p.direction().dot(up) - p.direction().dot(down);
        const Upright found = upright_near(discs, ahead < 0 ? up : down);
        if (found.share > std::max(best.share, near + clearly_more)) best = found;
    }
    return best.up;
}

}  // namespace

UpEstimate up_of_cameras(std::span<const Pose> poses) {
    if (poses.empty()) return {Vector3d::UnitZ(), 0};
    const Vector3d mean = mean_up(poses), suggested = best_suggestion(poses, mean);
    return refined(poses, suggested, angle_between(suggested, mean) < 3 * leaning ? mean : suggested);
}

std::optional<Vector3d> up_of_surface(std::span<const SurfaceDisc> discs, const Vector3d& held) {
    const Upright found = upright_near(discs, held);
    if (!(found.share >= least_upright)) return std::nullopt;
    return found.up;
}

Vector3d up_direction(std::span<const Pose> poses, std::span<const SurfaceDisc> discs) {
    UpEstimate e = up_of_cameras(poses);
    if (const auto surface = up_of_surface(discs, tilted(poses, e, discs))) e = {*surface, error_of_surface};
    Eigen::Index axis = 0;
    e.up.cwiseAbs().maxCoeff(&axis);
    const Vector3d nearest = Vector3d::Unit(axis) * std::copysign(1.0, e.up[axis]);
    return angle_between(e.up, nearest) < std::min(within * e.error, farthest_axis) ? nearest : e.up;
}

}  // namespace vantage
