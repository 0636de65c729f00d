#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "player/view.h"
#include "scene/package_format.h"

namespace vantage {

inline constexpr std::uint32_t most_levels = 12;

/// Tiles of one photo, by level; each list ascending, without doubles. Depth has the tiles of the masks.
struct TileNeeds {
    std::array<std::vector<std::uint32_t>, most_levels> color, masks;
    std::size_t tiles() const;  ///< colour, and masks with their depth as one
};

/// The tiles that a view samples in one photo for these clusters: from each cluster's recorded extent in the
/// photo, on the levels that its fragments sample.
TileNeeds tile_needs(const package::PhotoRecord& photo, std::span<const package::ClusterRecord> clusters,
                     std::span<const package::CoverageRecord> coverage, std::span<const std::uint32_t> drawn,
                     const View& view, double samples);

/// The colour tiles that show the whole photo with `density` samples a photo pixel's side.
TileNeeds whole_photo_needs(const package::PhotoRecord& photo, double density);

}  // namespace vantage
