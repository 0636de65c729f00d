#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// For each triangle, the number of photos that see it at least in part.
std::vector<unsigned> photos_per_triangle(const PackageReader& package);

/// The fractions of the model's surface that are seen by 0, 1, 2, 3 to 4, and 5 or more photos.
std::array<double, 5> covered_area(const PackageReader& package, const std::vector<unsigned>& photos);
/// The name and sRGB color of one of these five classes.
struct CoverageClass {
    const char* name;
    std::array<std::uint8_t, 3> color;
};
extern const std::array<CoverageClass, 5> coverage_classes;

struct CoveragePicture {
    std::string from;  ///< the side from which the model is seen: "+x", "-x", ..., "above (+z)", "below (-z)"
    RgbaImage image;
};
/// Pictures of the upright model from all six sides, in parallel projection along its axes, colored by the
/// number of photos that see the surface. `size` is the longer side of a picture in pixels. The views from
/// above and below come last.
std::vector<CoveragePicture> coverage_pictures(const PackageReader& package,
                                               const std::vector<unsigned>& photos, int size);

}  // namespace vantage
