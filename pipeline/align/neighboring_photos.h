#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/input/scene_input.h"

namespace vantage {

/// Two photos, as indices.
using TwoPhotos = std::array<std::uint32_t, 2>;

/// Photos of one image set whose cameras stand near each other, not in the same place, and look in similar
/// directions (to 50 degrees):
/// for up to `most` of them, spread over the list, those of these ranks by distance, 0 being the nearest.
/// Only distances and angles between cameras count, so that the result does not depend on where the mesh is.
/// Each pair once, the lower index first.
std::vector<TwoPhotos> neighboring_photos(std::span<const PhotoInput> photos, std::size_t most,
                                          std::span<const std::size_t> ranks);

}  // namespace vantage
