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

/// Decides for each such photo from the features that it shares with its neighbors: they lie near the
/// epipolar lines only if the photo is turned, or only if it is not. Tests at most 300 photos. Both lists are
/// empty if no orientation is in doubt.
OpenTurns find_open_turns(std::span<const PhotoInput> photos, const FeatureSettings& how);

/// Changes the camera's size and principal point to those of the photo after a turn by 90 degrees about its
/// center. Because of the new size, read_photo() turns the pixels.
void take_as_displayed(PhotoInput& photo);

}  // namespace vantage
