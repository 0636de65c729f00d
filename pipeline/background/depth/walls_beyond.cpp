#include "pipeline/background/depth/walls_beyond.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

namespace vantage {
namespace {

constexpr std::size_t max_walls = 3;
constexpr int wall_tries = 300;
constexpr double least_wall_share = 0.06;
constexpr float tolerance = 0.5f;  ///< labels
constexpr float near = 0.97f;      ///< cosine between the two directions that define a trial wall

/// A direction's horizontal component and its inverse distance; the points on a wall satisfy inverse = slope
/// . level.
struct WallSighting {
    Eigen::Vector2f level;
    Eigen::Vector3f direction;
    float inverse;
};

bool lies_on(const WallSighting& s, const Eigen::Vector2f& slope, float within) {
    return std::abs(slope.dot(s.level) - s.inverse) < within;
}

/// A sighting near the given one; the given one itself if none is found.
const WallSighting& neighbor(const std::vector<WallSighting>& all, const WallSighting& of,
                             std::mt19937_64& random) {
    for (int i = 0; i < 64; ++i)
        if (const WallSighting& s = all[random() % all.size()]; s.direction.dot(of.direction) > near)
            return s;
    return of;
}

/// The slope of the wall with the most sightings.
Eigen::Vector2f best_slope(const std::vector<WallSighting>& all, float within, std::mt19937_64& random) {
    Eigen::Vector2f best = Eigen::Vector2f::Zero();
    std::ptrdiff_t most = 0;
    for (int i = 0; i < wall_tries; ++i) {
        const WallSighting& a = all[random() % all.size()];
        const WallSighting& b = neighbor(all, a, random);
        Eigen::Matrix2f rows;
        rows << a.level.transpose(), b.level.transpose();
        if (std::abs(rows.determinant()) < 0.02f) continue;  // one above the other
        const Eigen::Vector2f slope = rows.inverse() * Eigen::Vector2f(a.inverse, b.inverse);
        const std::ptrdiff_t count =
            std::ranges::count_if(all, [&](const WallSighting& s) { return lies_on(s, slope, within); });
        if (count > most) most = count, best = slope;
    }
    return best;
}

Eigen::Vector2d fitted(const std::vector<WallSighting>& sightings) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const WallSighting& s : sightings) {
        const Eigen::Vector2d d = s.level.cast<double>();
        normal += d * d.transpose();
        right += double(s.inverse) * d;
    }
    return normal.fullPivLu().solve(right);
}

}  // namespace

std::vector<Plane> walls_beyond(const SweptDepths& depths, const DirectionSphere& sphere,
                                const std::vector<float>& inverse, const Eigen::Vector3d& down) {
    Eigen::Matrix<double, 2, 3> level;
    level.row(0) = down.unitOrthogonal().transpose();
    level.row(1) = down.cross(level.row(0).transpose()).transpose();
    std::vector<WallSighting> left;
    for (const std::uint32_t v : depths.shown)
        if (inverse[v] > depths.base[v] + 2 * depths.step)
            left.push_back({level.cast<float>() * sphere.directions[v], sphere.directions[v], inverse[v]});
    const double least = least_wall_share * double(depths.shown.size());
    std::vector<Plane> walls;
    std::mt19937_64 random(1);
    while (walls.size() < max_walls && double(left.size()) > std::max(least, 3.0)) {
        const Eigen::Vector2f tried = best_slope(left, tolerance * depths.step, random);
        std::vector<WallSighting> on;
        for (const WallSighting& s : left)
            if (lies_on(s, tried, tolerance * depths.step)) on.push_back(s);
        if (double(on.size()) < least) break;
        const Eigen::Vector2d slope = fitted(on);
        const double length = slope.norm();
        if (!(length > 0)) break;
        const Eigen::Vector3d normal = level.transpose() * slope / length;
        walls.push_back({normal, normal.dot(depths.center) + 1 / length});
        std::erase_if(left, [&](const WallSighting& s) {
            return lies_on(s, tried, depths.step) || lies_on(s, slope.cast<float>(), 2 * depths.step);
        });
    }
    return walls;
}

}  // namespace vantage
