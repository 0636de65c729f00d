#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/selection/tile_needs.h"
#include "player/stream/tile_stream.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Page numbers of all tiles of a package; those of a photo are consecutive, level by level.
struct PhotoPages {
    std::array<std::uint32_t, max_levels> color{}, masks{};  ///< first page of each level
    std::uint32_t color_first = 0, color_count = 0, mask_first = 0, mask_count = 0;
};
struct PackagePages {
    std::vector<PhotoPages> photos;
    std::uint32_t color = 0, masks = 0;  ///< pages in total
};
/// Throws Error(damaged) for a photo with more levels than the shaders support.
PackagePages number_pages(std::span<const package::PhotoRecord> photos);

StreamRequest color_request(const PackageReader& package, const PackagePages& pages, std::uint32_t photo,
                            std::uint32_t level, std::uint32_t tile);
StreamRequest mask_request(const PackageReader& package, const PackagePages& pages, std::uint32_t photo,
                           std::uint32_t level, std::uint32_t tile);
StreamRequest thumbnail_request(const PackageReader& package, std::uint32_t photo);

}  // namespace vantage
