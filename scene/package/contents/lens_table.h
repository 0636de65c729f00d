#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// How a lens displaces the pixels of a pinhole camera with the same intrinsics, as a uniform bicubic
/// B-spline over the camera's frame. C++ code and shaders thus evaluate every lens model in the same way, and
/// the result is within 0.02 px of distort() (LensTables in
/// tests/scene/package/contents/lens_table_test.cpp).
struct LensTable {
    static constexpr int cells = 64;         ///< number of cells along each side of the frame
    static constexpr int side = cells + 3;   ///< coefficients per side; cell i uses coefficients i to i + 3
    Intrinsics camera;                       ///< in pixels at full size
    double range = 0;                        ///< lens_range(), at most 1e9
    std::vector<Eigen::Vector2f> displaced;  ///< side * side coefficients in pixels, row by row
};

LensTable lens_table(const Intrinsics& camera, const Lens& lens);
/// The table of a photo in a package; empty if the photo has no lens. Throws Error(damaged), see lens_of().
std::optional<LensTable> lens_table(const PackageReader& package, const package::PhotoRecord& record,
                                    std::uint32_t photo);

/// The four coefficients that contribute at a coordinate of the frame, and their weights, which sum to 1.
struct SplinePlace {
    int first;
    std::array<float, 4> weights;
};
/// `share`: the position as a fraction of the frame's width or height; it is clamped to [0, 1].
SplinePlace spline_place(double share);

/// The position in the photo that corresponds to the pinhole camera's `pixel`; NaN beyond the lens's range.
/// Outside the frame, the displacement is that of the nearest pixel inside.
Eigen::Vector2d photo_pixel(const LensTable& table, const Eigen::Vector2d& pixel);

/// The largest displacement in pixels relative to a pinhole camera, sampled on a grid over the photo. The
/// result is 0 for a camera without distortion, and never NaN.
double largest_displacement(const Camera& camera);

/// The bounds of the image that the lens forms of a rectangle of pinhole pixels. Beyond the lens's range, the
/// spline is extrapolated.
Eigen::AlignedBox2d photo_bounds(const LensTable& table, const Eigen::AlignedBox2d& pixels);

/// For each texel of a level of the pinhole camera's frame, 1 if its image lies inside the photo and at least
/// a texel from the edge; empty if this applies to all texels.
std::vector<std::uint8_t> inside_photo(const LensTable& table, int level);

}  // namespace vantage
