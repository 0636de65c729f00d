#include "values/main_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "values/quantile.h"

namespace vantage {
namespace {

constexpr double stray_ratio = 20;  ///< of distances; nearer vertices cost little precision

std::vector<std::uint32_t> vertices_in_use(std::size_t vertices,
                                           std::span<const std::array<std::uint32_t, 3>> triangles) {
    std::vector<bool> used(vertices, triangles.empty());
    for (const auto& t : triangles)
        for (const std::uint32_t v : t) used[v] = true;
    std::vector<std::uint32_t> out;
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (used[v]) out.push_back(v);
    return out;
}

void extend(MainBox& box, const Eigen::Vector3d& p) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
}

/// Distances from the median of each coordinate, the largest of the three axes.
std::vector<double> distances_from_median(std::span<const Eigen::Vector3d> positions,
                                          std::span<const std::uint32_t> vertices) {
    std::vector<double> out(vertices.size(), 0), values(vertices.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(vertices, values.begin(), [&](auto v) { return positions[v][axis]; });
        const double median = upper_median<double>(values);
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = std::max(out[i], std::abs(positions[vertices[i]][axis] - median));
    }
    return out;
}

/// The largest distance that is not a stray's.
double reach_of(std::vector<double> distances) {
    const std::size_t n = distances.size(), most = std::min(std::max<std::size_t>(3, n / 100), n / 4);
    const auto last = distances.end() - std::ptrdiff_t(most) - 1;
    std::nth_element(distances.begin(), last, distances.end());
    return *last > 0 ? stray_ratio * *last : std::numeric_limits<double>::infinity();
}

}  // namespace

MainBox main_box(std::span<const Eigen::Vector3d> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles) {
    MainBox box;
    if (positions.empty()) return box;
    const std::vector<std::uint32_t> vertices = vertices_in_use(positions.size(), triangles);
    const std::vector<double> distances = distances_from_median(positions, vertices);
    const double reach = reach_of(distances);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (distances[i] > reach) box.strays.push_back(vertices[i]);
    if (box.strays.empty()) {
        box.low = box.high = positions.front();
        for (const Eigen::Vector3d& p : positions) extend(box, p);
        return box;
    }
    bool first = true;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Eigen::Vector3d& p = positions[vertices[i]];
        if (distances[i] > reach) continue;
        if (std::exchange(first, false)) box.low = box.high = p;
        extend(box, p);
    }
    return box;
}

bool has_stray(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::AlignedBox3d& bounds) {
    if (bounds.isEmpty()) return false;
    const double most = bounds.diagonal().norm();
    return std::ranges::any_of(
        corners, [&](const auto& p) { return bounds.exteriorDistance(p.template cast<double>()) > most; });
}

}  // namespace vantage
