#pragma once
#include <vector>

#include "player/measure/evaluation/error_causes.h"

namespace vantage {

/// Where a cause does the most harm.
struct WorstRegion {
    Cause cause;
    Place place;
    double squares;  ///< squared error that the cause adds here
};

/// For each cause the square (see searched_side) with the largest squared error of that cause; those with at
/// least 1 % of the frame's squared error (for causes at colored pixels, of the error there), the largest
/// `most` of them, largest first.
std::vector<WorstRegion> worst_regions(const CauseMap& map, std::size_t most);

/// Crops of a region, left to right: the photo, the picture, their difference (see difference_picture) in the
/// cells with the region's cause, and the first two pictures from single photos, as far as they exist.
Picture region_picture(const CauseMap& map, const WorstRegion& region, const Picture& photo,
                       const Picture& shown, std::span<const Picture> alone);

/// One pixel per cell: the color of the cause of most of its error, darker for less; black for none, full
/// from a root mean square of 40 gray levels.
Picture cause_picture(const CauseMap& map);

}  // namespace vantage
