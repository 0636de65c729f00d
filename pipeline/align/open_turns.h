#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/align/shared_features.h"

namespace vantage {

/// Photos whose EXIF orientation leaves open how their pixels lie for their cameras: another program has
/// turned the pixels and kept the tag, or the cameras are of the photos as displayed.
struct OpenTurns {
    std::vector<std::uint32_t> found;    ///< to be turned by PhotoInput::open_turn
    std::vector<std::uint32_t> unknown;  ///< nothing tells
};

/// The neighbors of photos in question tell: features that they share lie near the epipolar lines if they are
/// turned, and only then, or only as they are. At most 300 photos are tried. Empty if no photo is in
/// question.
OpenTurns find_open_turns(std::span<const PhotoInput> photos, const FeatureSettings& how);

/// Takes a photo whose camera is about its middle turned by 90 degrees: read_photo() goes by the size.
void take_as_displayed(PhotoInput& photo);

}  // namespace vantage
