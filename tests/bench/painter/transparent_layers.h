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

/// The transparent triangles of a package, rendered pixel by pixel in double precision, as the player should
/// show them.
class TransparentLayers {
  public:
    explicit TransparentLayers(const PackageReader& package);

    struct Fragment {
        double z;                ///< linear depth
        std::uint32_t triangle;  ///< index of the triangle in the package
        Eigen::Vector3d color;   ///< linear light, shaded
        double alpha;
    };
    struct Pixel {
        std::vector<Fragment> fragments;
        bool edge = false;  ///< a triangle's edge is so close that coverage depends on rounding
    };
    /// The fragments at the pixel centers, row by row; each pixel's fragments are in the order of their
    /// triangles.
    std::vector<Pixel> fragments(const View& view) const;

    /// The fragment of a triangle at a pixel's center; empty if the triangle does not cover it.
    std::optional<Fragment> at(const View& view, std::uint32_t triangle, const Eigen::Vector2d& pixel,
                               double* edge = nullptr) const;

    std::uint32_t first() const { return first_; }
    /// The corners of each transparent triangle, relative to the package's origin.
    std::vector<std::array<Eigen::Vector3d, 3>> triangles() const;

  private:
    std::uint32_t first_;  ///< first transparent triangle
    std::vector<Eigen::Vector3d> positions_, normals_;
    std::vector<std::array<double, 4>> colors_;  ///< sRGB and alpha, 0 to 1
    std::vector<std::uint32_t> indices_;
};

/// Sorts fragments by distance, then by triangle (the lowest number is nearest), and blends them over
/// `behind`. Colors consist of linear light and coverage.
Eigen::Vector4d blended(std::vector<TransparentLayers::Fragment> fragments, Eigen::Vector4d behind);

}  // namespace vantage
