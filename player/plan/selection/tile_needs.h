#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/selection/sampling.h"
#include "scene/package/contents/lens_table.h"
#include "scene/package/package_format.h"

namespace vantage {

inline constexpr std::uint32_t max_levels = 12;

/// Tiles of one photo, by level; each list is ascending and without duplicates. Depth needs the same tiles as
/// the weight maps.
struct TileNeeds {
    std::array<std::vector<std::uint32_t>, max_levels> color, weight_maps;
    std::size_t tiles() const;  ///< number of tiles; weight maps and depth of a tile count once
};

/// A cluster and the levels on which its fragments sample the photo.
struct ClusterLevels {
    std::uint32_t cluster;
    LevelRange levels;
};
/// The tiles of one photo that these clusters sample: those in each cluster's recorded extent, on the
/// cluster's levels. `lens`: null if the photo has no lens table.
TileNeeds tile_needs(const package::PhotoRecord& photo, const LensTable* lens,
                     std::span<const package::CoverageRecord> coverage,
                     std::span<const ClusterLevels> clusters);

/// The color tiles of the whole photo, for `density` samples per side of a photo pixel.
TileNeeds whole_photo_needs(const package::PhotoRecord& photo, double density);

}  // namespace vantage
