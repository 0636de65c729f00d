#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// Photos whose cameras are not theirs.
struct MisplacedPhotos {
    std::vector<std::string> warnings;  ///< a line per two photos that are swapped, and per other photo
    bool swapped = false;               ///< any two
};

/// Suspects are photos with pairs that contradict, or are displaced by more than 0.3 % of the photo: at most
/// 12, those with the largest share of such pairs. Two suspects are swapped if each fits its neighbors with
/// the other's camera, and at least twice as well as with its own. Of the other photos, those are reported
/// that contradict all photos but swapped ones. Throws Error(damaged).
MisplacedPhotos misplaced_photos(const PoseRefinementInput& input,
                                 std::span<const package::PairRecord> pairs);

}  // namespace vantage
