#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "player/view/view.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The transparent triangles of a package in double precision: what a player shows of them, computed pixel by
/// pixel.
class TransparentLayers {
  public:
    explicit TransparentLayers(const PackageReader& package);

    struct Fragment {
        double z;                ///< distance along the view's axis
        std::uint32_t triangle;  ///< of the package
        Eigen::Vector3d color;   ///< linear light, shaded
        double alpha;
    };
    struct Pixel {
        std::vector<Fragment> fragments;
        bool edge = false;  ///< a triangle's edge is so near that rounding decides
    };
    /// The fragments at the pixels' centers, row by row, in the order of triangles.
    std::vector<Pixel> fragments(const View& view) const;

    /// Where a pixel's center shows the plane of a triangle; nothing if it does not meet the triangle.
    std::optional<Fragment> at(const View& view, std::uint32_t triangle, const Eigen::Vector2d& pixel,
                               double* edge = nullptr) const;

    std::uint32_t first() const { return first_; }
    /// Corners of each transparent triangle, relative to the origin.
    std::vector<std::array<Eigen::Vector3d, 3>> triangles() const;

  private:
    std::uint32_t first_;  ///< transparent triangle
    std::vector<Eigen::Vector3d> positions_, normals_;
    std::vector<std::array<double, 4>> colors_;  ///< sRGB and alpha, 0 to 1
    std::vector<std::uint32_t> indices_;
};

/// Sorts fragments by distance, those of equal distance by triangle (the lowest number is nearest), and
/// blends them over `behind`: linear light, and the share of the pixel that is not empty.
Eigen::Vector4d blended(std::vector<TransparentLayers::Fragment> fragments, Eigen::Vector4d behind);

}  // namespace vantage
