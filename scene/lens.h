#pragma once
#include <Eigen/Core>
#include <array>
#include <string_view>

namespace vantage {

/// Lens distortion models that cover the cameras of COLMAP, Bundler and MeshLab.
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

    /// False if distort() is the identity.
    bool distorts() const;
};

/// The model's name in messages.
std::string_view name(LensModel model);

/// The largest normalized pinhole radius up to which the distorted radius increases, tangential terms
/// ignored. Beyond it the lens's polynomial folds back and is meaningless. Infinite if it never does.
double lens_range(const Lens& lens);

/// Normalized pinhole coordinates (x/z, y/z) to normalized coordinates as distorted by the lens. Continuous
/// at the center for every model. Finite input gives finite output within lens_range().
Eigen::Vector2d distort(const Lens& lens, const Eigen::Vector2d& xy);

}  // namespace vantage
