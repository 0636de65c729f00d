#pragma once
#include <vector>

#include "player/measure/evaluation/error_causes.h"

namespace vantage {

/// The region with the largest error of a cause.
struct WorstRegion {
    Cause cause;
    Place place;
    double squares;  ///< squared error from this cause in the region
};

/// For each cause, the square (see searched_side) with the largest squared error from that cause. Keeps
/// squares with at least 1 % of the frame's squared error or, for causes at colored pixels, of the squared
/// error at these pixels. Returns the `most` largest of them, largest first.
std::vector<WorstRegion> worst_regions(const CauseMap& map, std::size_t most);

/// Crops of a region, left to right: the photo, the picture, their difference (see difference_picture) in the
/// cells with the region's cause, and the first two pictures from single photos, if they exist.
Picture region_picture(const CauseMap& map, const WorstRegion& region, const Picture& photo,
                       const Picture& shown, std::span<const Picture> alone);

/// One pixel per cell: the color of the cause with the largest error. It is darker for smaller errors, black
/// for none, and at full brightness for a root mean square of 40 gray levels or more.
Picture cause_picture(const CauseMap& map);

}  // namespace vantage
