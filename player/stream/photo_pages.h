#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/selection/tile_needs.h"
#include "player/stream/tile_stream.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Page numbers of all tiles of a package. A photo's pages are numbered consecutively, level by level.
struct PhotoPages {
    std::array<std::uint32_t, max_levels> color{}, weight_maps{};  ///< first page of each level
    std::uint32_t color_first = 0, color_count = 0, weight_map_first = 0, weight_map_count = 0;
};
struct PackagePages {
    std::vector<PhotoPages> photos;
    std::uint32_t color = 0, weight_maps = 0;  ///< pages in total
};
/// Throws Error(damaged) if a photo has more levels than the shaders support.
PackagePages number_pages(std::span<const package::PhotoRecord> photos);

StreamRequest color_request(const PackageReader& package, const PackagePages& pages, std::uint32_t photo,
                            std::uint32_t level, std::uint32_t tile);
StreamRequest weight_map_request(const PackageReader& package, const PackagePages& pages, std::uint32_t photo,
                                 std::uint32_t level, std::uint32_t tile);
/// The level of color without which a photo is not drawn: the second coarsest.
std::uint32_t base_level(const package::PhotoRecord& photo);
/// The number of tiles in the base level, at most four.
std::uint32_t base_tiles(const package::PhotoRecord& photo);
StreamRequest thumbnail_request(const PackageReader& package, std::uint32_t photo);

}  // namespace vantage
