#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/surroundings/planes.h"

namespace vantage {
namespace {

constexpr std::size_t most_planes = 3;
constexpr int tries = 300;
constexpr double least_share = 0.04, thickness = 0.01;  ///< of the mesh's extent
constexpr float same_way = 0.9f;                        ///< cosine between normals

using Disc = SurfaceDisc;

/// Distance between the 2nd and the 98th percentile, diagonally.
double extent_of(std::span<const Disc> discs) {
    Eigen::Vector3d extent;
    std::vector<float> values(discs.size());
    for (int c = 0; c < 3; ++c) {
        std::ranges::transform(discs, values.begin(), [c](const Disc& d) { return d.center[c]; });
        std::ranges::sort(values);
        extent[c] = double(values[values.size() * 49 / 50] - values[values.size() / 50]);
    }
    return extent.norm();
}

Plane fitted(const std::vector<const Disc*>& discs) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Disc* d : discs) mean += d->center.cast<double>() / double(discs.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Disc* d : discs) {
        const Eigen::Vector3d off = d->center.cast<double>() - mean;
        scatter += off * off.transpose();
    }
    const Eigen::Vector3d normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
    return {normal, normal.dot(mean)};
}

}  // namespace

std::vector<Plane> mesh_planes(std::span<const Disc> discs) {
    std::vector<Plane> planes;
    std::vector<const Disc*> left;
    for (const Disc& d : discs)
        if (d.normal.squaredNorm() > 0) left.push_back(&d);
    if (left.size() < 100) return planes;
    const double thick = thickness * extent_of(discs);
    std::mt19937_64 random(1);
    const double least = least_share * double(left.size());
    while (planes.size() < most_planes && double(left.size()) > least) {
        std::vector<const Disc*> best;
        for (int i = 0; i < tries; ++i) {
            const Disc& seed = *left[random() % left.size()];
            std::vector<const Disc*> on;
            for (const Disc* d : left)
                if (std::abs((d->center - seed.center).dot(seed.normal)) < thick &&
                    std::abs(d->normal.dot(seed.normal)) > same_way)
                    on.push_back(d);
            if (on.size() > best.size()) best = std::move(on);
        }
        if (double(best.size()) < least) break;
        const Plane plane = planes.emplace_back(fitted(best));
        std::erase_if(left, [&](const Disc* d) {
            return std::abs(plane.normal.dot(d->center.cast<double>()) - plane.height) < thick;
        });
    }
    return planes;
}

}  // namespace vantage
