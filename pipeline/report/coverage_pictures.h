#pragma once
#include <array>
#include <string>
#include <vector>

#include "pipeline/pixels/rgba_image.h"
#include "scene/package_reader.h"

namespace vantage {

/// How many photos see each triangle, at least in part.
std::vector<unsigned> photos_a_triangle(const PackageReader& package);

/// The share of the model's surface that 0, 1, 2, 3 to 4, and more photos see.
std::array<double, 5> covered_area(const PackageReader& package, const std::vector<unsigned>& photos);
/// What those classes are called, and their colours, sRGB.
struct CoverageClass {
    const char* name;
    std::array<std::uint8_t, 3> color;
};
extern const std::array<CoverageClass, 5> coverage_classes;

struct CoveragePicture {
    std::string from;  ///< the direction looked from: "+x", "-x", ...
    RgbaImage image;
};
/// The model from the six directions of its axes, in parallel projection, coloured by how many photos see it.
std::vector<CoveragePicture> coverage_pictures(const PackageReader& package,
                                               const std::vector<unsigned>& photos, int size);

}  // namespace vantage
