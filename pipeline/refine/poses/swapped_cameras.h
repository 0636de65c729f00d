#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// Photos with wrong cameras.
struct MisplacedPhotos {
    std::vector<std::string> warnings;  ///< one line per swapped pair, and per other misplaced photo
    bool swapped = false;               ///< whether any two cameras are swapped
};

/// A pair is bad if its photos contradict each other or if its displacement exceeds 0.3 % of the longer side.
/// Suspects are the photos with the largest fraction of bad pairs, at most 12. The cameras of two suspects
/// are swapped if each photo fits its neighbors with the other's camera, and at least twice as well as with
/// its own. Other photos are reported if they contradict all photos except those with swapped cameras. Throws
/// Error(damaged).
MisplacedPhotos misplaced_photos(const PoseRefinementInput& input,
                                 std::span<const package::PairRecord> pairs);

}  // namespace vantage
