#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/align/shared_features.h"

namespace vantage {

/// Photos that are upside down for their cameras, of those whose EXIF orientation leaves that open: another
/// program has turned the pixels and kept the tag, or the cameras are of the photos as displayed. Their
/// neighbors tell: features that they share lie near the epipolar lines if they are turned by 180 degrees,
/// and only then. At most twelve photos are tried. Empty if no photo is in question.
std::vector<std::uint32_t> upside_down_photos(std::span<const PhotoInput> photos, const FeatureSettings& how);

}  // namespace vantage
