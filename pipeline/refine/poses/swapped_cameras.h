#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// Photos with wrong cameras.
struct MisplacedPhotos {
    std::vector<std::string> warnings;  ///< one line per swapped pair, and per other photo
    bool swapped = false;               ///< whether any two photos are swapped
};

/// Suspects are photos in pairs whose photos contradict each other, or whose displacement exceeds 0.3 % of
/// the longer side: at most 12, those with the largest fraction of such pairs. Two suspects are swapped if
/// each fits its neighbors with the other's camera, and at least twice as well as with its own. Other photos
/// are reported if they contradict all photos except swapped ones. Throws Error(damaged).
MisplacedPhotos misplaced_photos(const PoseRefinementInput& input,
                                 std::span<const package::PairRecord> pairs);

}  // namespace vantage
