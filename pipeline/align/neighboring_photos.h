#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/input/scene_input.h"

namespace vantage {

/// The indices of two photos.
using TwoPhotos = std::array<std::uint32_t, 2>;

/// Pairs of photos of one image set whose cameras are close to each other, but not at the same place, and
/// face similar directions (within 50 degrees). For each of up to `most` photos, spread over the list,
/// `ranks` selects the neighbors by their distance: 0 is the nearest. The result depends only on distances
/// and angles between cameras, and so not on the mesh's pose. Each pair occurs once, the lower index first.
std::vector<TwoPhotos> neighboring_photos(std::span<const PhotoInput> photos, std::size_t most,
                                          std::span<const std::size_t> ranks);

}  // namespace vantage
