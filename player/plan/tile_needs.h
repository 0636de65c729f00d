#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/sampling.h"
#include "scene/package_format.h"

namespace vantage {

inline constexpr std::uint32_t most_levels = 12;

/// Tiles of one photo, by level; each list ascending, without doubles. Depth has the tiles of the masks.
struct TileNeeds {
    std::array<std::vector<std::uint32_t>, most_levels> color, masks;
    std::size_t tiles() const;  ///< colour, and masks with their depth as one
};

/// A cluster and the levels on which its fragments sample the photo.
struct ClusterLevels {
    std::uint32_t cluster;
    LevelRange levels;
};
/// The tiles of one photo that these clusters sample: each one's recorded extent in the photo, on its levels.
TileNeeds tile_needs(const package::PhotoRecord& photo, std::span<const package::CoverageRecord> coverage,
                     std::span<const ClusterLevels> clusters);

/// The colour tiles that show the whole photo with `density` samples a photo pixel's side.
TileNeeds whole_photo_needs(const package::PhotoRecord& photo, double density);

}  // namespace vantage
