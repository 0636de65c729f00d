#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/align/shared_features.h"

namespace vantage {

/// Photos whose EXIF orientation leaves open whether they are upside down for their cameras: another program
/// has turned the pixels and kept the tag, or the cameras are of the photos as displayed.
struct OpenTurns {
    std::vector<std::uint32_t> found;    ///< upside down
    std::vector<std::uint32_t> unknown;  ///< nothing tells
};

/// The neighbors of photos in question tell: features that they share lie near the epipolar lines if they are
/// turned by 180 degrees, and only then, or only as they are. At most 300 photos are tried. Empty if no photo
/// is in question.
OpenTurns find_open_turns(std::span<const PhotoInput> photos, const FeatureSettings& how);

}  // namespace vantage
