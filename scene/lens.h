#pragma once
#include <Eigen/Core>
#include <array>
#include <string_view>

namespace vantage {

/// Lens distortion families that cover COLMAP's camera models, Bundler's and MeshLab's.
enum class LensModel : int {
    none,
    opencv,     ///< p = k1 k2 p1 p2 k3 k4 k5 k6 (rational radial and tangential, OpenCV order)
    fisheye,    ///< p = k1 k2 k3 k4 (Kannala-Brandt: theta (1 + k1 theta^2 + ...))
    fov,        ///< p = omega (Devernay and Faugeras 2001)
    thin_prism  ///< p = k1 k2 p1 p2 k3 k4 sx1 sy1 (Weng, on the equidistant angle, as COLMAP)
};

struct Lens {
    LensModel model = LensModel::none;
    std::array<double, 8> p{};

    /// True where distort() is not the identity.
    bool distorts() const;
};

std::string_view name(LensModel model);

/// The largest normalised pinhole radius up to which farther from the axis is farther in the photo,
/// tangential terms aside: beyond it a lens's polynomial folds back, and says nothing. Infinite where it
/// never does.
double lens_range(const Lens& lens);

/// Normalised pinhole coordinates (x/z, y/z) -> normalised coordinates as the lens draws them.
/// Continuous at the centre for every model. Finite input gives finite output within the lens' range.
Eigen::Vector2d distort(const Lens& lens, const Eigen::Vector2d& xy);

}  // namespace vantage
