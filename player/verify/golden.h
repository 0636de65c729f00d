#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/render/picture.h"
#include "player/shots.h"
#include "scene/package_reader.h"

namespace vantage {

/// Views of a package to look at again and again: beside and between up to four of its photos, spread over
/// all, where several photos are blended.
void write_usual_views(const std::filesystem::path& file, const PackageReader& package);

/// How a picture differs from the stored one.
struct GoldenDifference {
    std::string view, problem;    ///< the problem says why they cannot be compared, else empty
    int worst = 0, x = 0, y = 0;  ///< grey levels, and where
    double share = 0;             ///< of the pixels that are off by more than the tolerance
    double mean = 0;              ///< grey levels
};
/// The largest difference of a pixel's channels, alpha included, counts.
GoldenDifference compare_pictures(const Picture& stored, const Picture& now, int tolerance);

/// Stored, now, and the difference eight times, one beside the other.
Picture side_by_side(const Picture& stored, const Picture& now);

}  // namespace vantage
