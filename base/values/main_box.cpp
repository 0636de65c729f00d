#include "base/values/main_box.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/values/quantile.h"

namespace vantage {
namespace {

constexpr double stray_ratio = 20;  ///< ratio of distances; smaller ratios reduce precision only slightly

std::vector<std::uint32_t> vertices_in_use(std::size_t vertices,
                                           std::span<const std::array<std::uint32_t, 3>> triangles) {
    std::vector<char> used(vertices, triangles.empty());
    for (const auto& t : triangles)
        for (const std::uint32_t v : t) used[v] = true;
    std::vector<std::uint32_t> out;
    out.reserve(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (used[v]) out.push_back(v);
    return out;
}

/// For each vertex, the largest of its distances from the medians of the three coordinates.
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

/// Maximum number of strays among `vertices`.
std::size_t max_strays(std::size_t vertices) {
    return std::min(std::max<std::size_t>(3, vertices / 100), vertices / 4);
}

/// Proves cheaply, without medians, that no vertex is a stray: along the longest axis, the outer 45 % at each
/// end contain more vertices than there may be strays. Wherever the median is, the vertices at one end are at
/// least 5 % of the length away from it, and no vertex is more than 20 times as far away.
bool fills_both_ends(std::span<const Eigen::Vector3d> positions, std::span<const std::uint32_t> vertices) {
    constexpr double share = 0.5 - 1 / stray_ratio;
    Eigen::AlignedBox3d box;
    for (const std::uint32_t v : vertices) box.extend(positions[v]);
    int axis = 0;
    const double length = box.sizes().maxCoeff(&axis);
    const double low = box.min()[axis] + share * length, high = box.max()[axis] - share * length;
    std::size_t at_low = 0, at_high = 0;
    for (const std::uint32_t v : vertices) {
        at_low += positions[v][axis] <= low;
        at_high += positions[v][axis] >= high;
    }
    return std::min(at_low, at_high) > max_strays(vertices.size());
}

/// The largest distance of a vertex that is not a stray.
double reach_of(std::vector<double> distances) {
    const auto last = distances.end() - std::ptrdiff_t(max_strays(distances.size())) - 1;
    std::nth_element(distances.begin(), last, distances.end());
    return *last > 0 ? stray_ratio * *last : std::numeric_limits<double>::infinity();
}

std::vector<std::uint32_t> strays_of(std::span<const Eigen::Vector3d> positions,
                                     std::span<const std::uint32_t> vertices) {
    std::vector<std::uint32_t> out;
    if (fills_both_ends(positions, vertices)) return out;
    const std::vector<double> distances = distances_from_median(positions, vertices);
    const double reach = reach_of(distances);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (distances[i] > reach) out.push_back(vertices[i]);
    return out;
}

}  // namespace

double MainBox::diagonal() const { return (high - low).norm(); }
double MainBox::distance(const Eigen::Vector3d& p) const {
    return (p - p.cwiseMax(low).cwiseMin(high)).norm();
}

bool has_stray(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::AlignedBox3d& bounds) {
    if (bounds.isEmpty()) return false;
    const double most = bounds.diagonal().squaredNorm();
    return std::ranges::any_of(corners, [&](const Eigen::Vector3f& p) {
        return bounds.squaredExteriorDistance(p.cast<double>()) > most;
    });
}

MainBox main_box(std::span<const Eigen::Vector3d> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles) {
    MainBox box;
    if (positions.empty()) return box;
    const std::vector<std::uint32_t> vertices = vertices_in_use(positions.size(), triangles);
    box.strays = strays_of(positions, vertices);
    Eigen::AlignedBox3d bounds;
    if (box.strays.empty()) {
        for (const Eigen::Vector3d& p : positions) bounds.extend(p);
    } else {
        std::vector<std::uint32_t> others;
        std::ranges::set_difference(vertices, box.strays, std::back_inserter(others));
        for (const std::uint32_t v : others) bounds.extend(positions[v]);
    }
    box.low = bounds.min();
    box.high = bounds.max();
    return box;
}

}  // namespace vantage
