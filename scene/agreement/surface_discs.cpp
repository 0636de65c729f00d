#include "scene/agreement/surface_discs.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "base/values/main_box.h"

namespace vantage {
namespace {

constexpr double disc_pixels = 48;  ///< radius of a disc in the finest photo

/// The n-th point in a triangle, from the R2 sequence (Roberts 2018) folded at the diagonal.
Eigen::Vector3f point_in(const std::array<Eigen::Vector3f, 3>& p, std::size_t n) {
    float u = float(std::fmod(0.7548776662466927 * double(n), 1.0)),
          v = float(std::fmod(0.5698402909980532 * double(n), 1.0));
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]);
}

}  // namespace

std::vector<SurfaceDisc> surface_disc_set(std::span<const Eigen::Vector3f> positions,
                                          std::span<const std::uint32_t> indices, double density,
                                          const Eigen::AlignedBox3d& bounds) {
    const std::size_t triangles = indices.size() / 3;
    const auto corners = [&](std::size_t t) {
        return std::array{positions[indices[3 * t]], positions[indices[3 * t + 1]],
                          positions[indices[3 * t + 2]]};
    };
    std::vector<double> area(triangles);
    double whole = 0;
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto p = corners(t);
        if (has_stray(p, bounds)) continue;
        area[t] = (p[1] - p[0]).cast<double>().cross((p[2] - p[0]).cast<double>()).norm();
        whole += area[t];
    }
    std::vector<SurfaceDisc> discs;
    const auto radius = float(disc_pixels / density);
    double passed = 0;
    for (std::size_t t = 0; t < triangles; ++t) {
        const double share = 0.5 * (whole > 0 ? area[t] / whole : 0) + 0.5 / double(triangles);
        passed += share * double(package::surface_discs);
        const auto p = corners(t);
        // Rounding must not drop the last disc.
        const double until = t + 1 == triangles ? double(package::surface_discs) : passed;
        while (discs.size() < package::surface_discs && double(discs.size()) + 0.5 < until)
            discs.push_back(
                {point_in(p, discs.size()), (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized(), radius});
    }
    return discs;
}

std::vector<SurfaceDisc> thinned(std::span<const SurfaceDisc> discs, std::size_t step) {
    std::vector<SurfaceDisc> out;
    for (std::size_t d = 0; d < discs.size(); d += step) out.push_back(discs[d]);
    return out;
}

}  // namespace vantage
