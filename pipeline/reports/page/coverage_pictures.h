#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The number of photos that see each triangle, at least in part.
std::vector<unsigned> photos_per_triangle(const PackageReader& package);

/// The fractions of the model's surface that 0, 1, 2, 3 or 4, and 5 or more photos see.
std::array<double, 5> covered_area(const PackageReader& package, const std::vector<unsigned>& photos);
/// Name and sRGB color of one of these five classes.
struct CoverageClass {
    const char* name;
    std::array<std::uint8_t, 3> color;
};
extern const std::array<CoverageClass, 5> coverage_classes;

struct CoveragePicture {
    std::string from;  ///< the side from which it is seen: "+x", "-x", ..., "above (+z)", "below (-z)"
    RgbaImage image;
};
/// The model seen along its axes from all six sides, upright, in parallel projection, colored
/// by the number of photos that see it; `size` is the longer side in pixels. The views from above and below
/// come last.
std::vector<CoveragePicture> coverage_pictures(const PackageReader& package,
                                               const std::vector<unsigned>& photos, int size);

}  // namespace vantage
