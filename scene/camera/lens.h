#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>

namespace vantage {

/// Lens distortion models map the direction of a ray to its position in the photo, in units of the focal
/// length. (x, y) is the direction, and r is its distance from the axis.
enum class LensModel : int {
    none,
    opencv,      ///< p = k1 k2 p1 p2 k3 k4 k5 k6 (rational radial and tangential, OpenCV order)
    fisheye,     ///< p = k1 k2 k3 k4 (Kannala-Brandt: theta (1 + k1 theta^2 + ...))
    fov,         ///< p = omega (Devernay and Faugeras 2001)
    thin_prism,  ///< p = k1 k2 p1 p2 k3 k4 sx1 sy1 (Weng, on the equidistant angle, as in COLMAP)
    brown,       ///< p = k1 k2 p1 p2 k3 k4 skew: a polynomial up to k4 r^8, OpenCV's p1 and p2 (Metashape)
    aria,        ///< p = k1 to k6, p1 p2, s1 to s4 on the equidistant angle (Project Aria's Fisheye624)
    division,    ///< p = k: x = x' / (1 + k r'^2), x' in the photo (Fitzgibbon 2001)
    matchmover,  ///< p = k: x = x' (1 + k r'^2), x' in the photo
    unified      ///< p = alpha, beta (extended unified model; Khomutenko et al. 2016)
};
inline constexpr LensModel last_lens_model = LensModel::unified;

struct Lens {
    LensModel model = LensModel::none;
    std::array<double, 12> p{};

    /// Returns false if distort() is the identity.
    bool distorts() const;
};

/// The model's name, as used in messages.
std::string_view name(LensModel model);

/// The names of the model's coefficients, in the order of Lens::p.
std::span<const char* const> coefficient_names(LensModel model);

/// The largest normalized pinhole radius up to which the distorted radius, without tangential terms,
/// increases. Beyond this radius, the lens's polynomial folds back and is meaningless. Infinite if it never
/// folds back.
double lens_range(const Lens& lens);

/// Maps normalized pinhole coordinates (x/z, y/z) to normalized coordinates distorted by the lens. Every
/// model is continuous at the center. Within lens_range(), finite input yields finite output.
Eigen::Vector2d distort(const Lens& lens, const Eigen::Vector2d& xy);

}  // namespace vantage
