#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/align/shared_features.h"

namespace vantage {

/// Photos whose EXIF orientation does not settle the orientation of their pixels relative to the cameras:
/// another program turned the pixels and kept the tag, or the cameras refer to the displayed photos.
struct OpenTurns {
    std::vector<std::uint32_t> found;    ///< photos that must be turned by PhotoInput::open_turn
    std::vector<std::uint32_t> unknown;  ///< photos whose features are inconclusive
};

/// Decides from the features that such photos share with their neighbors: they lie near the epipolar lines
/// either only if the photo is turned or only if the photo is not. Tests at most 300 photos. Both lists are
/// empty if no orientation is in doubt.
OpenTurns find_open_turns(std::span<const PhotoInput> photos, const FeatureSettings& how);

/// Gives the camera the size of the photo turned by 90 degrees about its center; because of this size,
/// read_photo() then turns the pixels.
void take_as_displayed(PhotoInput& photo);

}  // namespace vantage
