#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <random>

#include "base/values/tiling.h"
#include "player/view/view.h"
#include "scene/package/package_format.h"

// Photos, clusters and views for tests.
namespace vantage {

/// A photo of `width` x `height` pixels with a focal length of 1500, which shows the model at a distance of
/// 10.
inline package::PhotoRecord photo_at(const Eigen::Vector3d& center, const Eigen::Matrix3d& R,
                                     int width = 1700, int height = 1300) {
    package::PhotoRecord p{};
    p.width = std::uint32_t(width);
    p.height = std::uint32_t(height);
    p.fx = p.fy = 1500;
    p.cx = 830;
    p.cy = 670;
    p.levels = std::uint32_t(level_count(width, height));
    p.seen_distance = 10;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(p.R) = R;
    Eigen::Map<Eigen::Vector3d>(p.t) = -R * center;
    return p;
}

/// Uniform random numbers with a fixed seed.
struct Random {
    std::mt19937 engine{7};
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    Eigen::Vector3d vector(double size) {
        return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
    }
};

inline package::ClusterRecord cluster_at(const Eigen::Vector3d& c, double r) {
    package::ClusterRecord cluster{};
    for (int i = 0; i < 3; ++i) cluster.center[i] = float(c[i]);
    cluster.radius = float(r);
    return cluster;
}

/// A camera that is a few units from the origin and looks roughly toward it.
inline View random_view(Random& random) {
    const Eigen::Vector3d eye = random.vector(1).normalized() * random(2, 12);
    return view_towards(eye, random.vector(1), Eigen::Vector3d(0, 0, 1), random(20, 90), 640, 480);
}

}  // namespace vantage
