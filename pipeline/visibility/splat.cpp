#include "pipeline/visibility/splat.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/values/grid.h"

namespace vantage {
namespace {

constexpr float unseen = std::numeric_limits<float>::infinity();
constexpr float filling = 2;   ///< radius of a splat that leaves few gaps, in half distances between points
constexpr float largest = 64;  ///< radius of a splat, texels
constexpr float hole_step = 0.02f;  ///< minimum depth of a hole behind its neighbors, relative to depth

/// Draws a disc of constant depth.
void draw(const Eigen::Vector2f& at, float radius, float z, Grid<float> map) {
    const auto put = [&](int x, int y) {
        float& there = map(x, y);
        there = std::min(there, z);
    };
    const int x = int(std::floor(at.x())), y = int(std::floor(at.y()));
    if (x >= 0 && y >= 0 && x < map.width && y < map.height) put(x, y);
    if (!(radius > 0.5f)) return;
    const int top = std::max(0, int(std::ceil(at.y() - radius - 0.5f))),
              bottom = std::min(map.height - 1, int(std::floor(at.y() + radius - 0.5f)));
    for (int row = top; row <= bottom; ++row) {
        const float off = float(row) + 0.5f - at.y(),
                    half = std::sqrt(std::max(0.0f, radius * radius - off * off));
        const int left = std::max(0, int(std::ceil(at.x() - half - 0.5f))),
                  right = std::min(map.width - 1, int(std::floor(at.x() + half - 0.5f)));
        for (int column = left; column <= right; ++column) put(column, row);
    }
}

std::vector<float> splatted(const SplatCloud& cloud, const Intrinsics& k, const Pose& pose, int width,
                            int height) {
    std::vector<float> z(std::size_t(width) * std::size_t(height), unseen);
    const Grid<float> map{z.data(), width, height};
    const Eigen::Matrix3f R = pose.R.cast<float>();
    const Eigen::Vector3f t = pose.t.cast<float>();
    const auto fx = float(k.fx), fy = float(k.fy), cx = float(k.cx), cy = float(k.cy),
               focal = std::sqrt(float(k.fx * k.fy));
    for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
        const Eigen::Vector3f p = R * cloud.positions[i] + t;
        if (!(p.z() > 0)) continue;
        const float inverse = 1 / p.z(),
                    radius = std::min(filling * cloud.radii[i] * focal * inverse, largest);
        const Eigen::Vector2f at(fx * p.x() * inverse + cx, fy * p.y() * inverse + cy);
        const bool near_frame = at.x() > -radius && at.y() > -radius && at.x() < float(width) + radius &&
                                at.y() < float(height) + radius;
        if (near_frame && inverse < unseen) draw(at, radius, p.z(), map);
    }
    return z;
}

/// A texel that is farther than at least six of its eight neighbors takes the median depth of the nearer
/// ones.
std::vector<float> closed(const std::vector<float>& z, int width, int height) {
    std::vector<float> out = z;
    const auto at = [&](int x, int y) { return z[std::size_t(y) * std::size_t(width) + std::size_t(x)]; };
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            const float own = at(x, y);
            std::array<float, 8> nearer;
            std::size_t count = 0;
            for (int i = 0; i < 9; ++i)
                if (const float other = at(x + i % 3 - 1, y + i / 3 - 1); other * (1 + hole_step) < own)
                    nearer[count++] = other;
            if (count < 6) continue;
            const auto middle = nearer.begin() + std::ptrdiff_t(count / 2);
            std::nth_element(nearer.begin(), middle, nearer.begin() + std::ptrdiff_t(count));
            out[std::size_t(y) * std::size_t(width) + std::size_t(x)] = *middle;
        }
    return out;
}

}  // namespace

void splat(const SplatCloud& cloud, const Intrinsics& photo, const Pose& pose, double slack,
           PhotoGeometry& maps) {
    const std::vector<float> z = closed(splatted(cloud, map_intrinsics(photo), pose, maps.width, maps.height),
                                        maps.width, maps.height);
    for (std::size_t i = 0; i < z.size(); ++i) {
        const bool seen = z[i] < unseen;
        if (!seen || !(maps.z[i] <= z[i] + float(slack))) maps.triangles[i] = ~0u;
        maps.angle[i] = seen ? 255 : 0;
    }
    maps.z = z;
}

}  // namespace vantage
