#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/render/picture.h"
#include "player/view/shots.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Writes up to four views for regression tests of a package, each between neighboring photos, so that
/// several photos are blended; the pairs are evenly spaced in the list of photos.
void write_default_views(const std::filesystem::path& file, const PackageReader& package);

/// The difference between a picture and the stored picture.
struct GoldenDifference {
    std::string view, problem;    ///< `problem`: why the pictures cannot be compared, or empty
    int worst = 0, x = 0, y = 0;  ///< largest difference in gray levels, and its pixel
    double share = 0;             ///< fraction of pixels that differ by more than the tolerance
    double mean = 0;              ///< gray levels
};
/// The difference of two pixels is the largest difference of their channels, alpha included.
GoldenDifference compare_pictures(const Picture& stored, const Picture& now, int tolerance);

/// Stored picture, new picture, and eight times their difference, side by side.
Picture side_by_side(const Picture& stored, const Picture& now);

}  // namespace vantage
