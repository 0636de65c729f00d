#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package_format.h"
#include "scene/tiling.h"

namespace vantage {

inline constexpr std::uint32_t most_levels = 12;

/// A photo as shaders/photos.glsl reads it (std430).
struct PhotoBlock {
    float cam_from_origin[16];  ///< column by column
    float focal_center[4];
    float size_weight[4];
    float center_hull[4];
    float direction[4];
    std::uint32_t level_base[most_levels];
    std::uint32_t mask_base;
    std::uint32_t unused[3];
};
static_assert(sizeof(PhotoBlock) == 192);

/// Photos with their pages laid out one after the other.
struct PhotoBlocks {
    std::vector<PhotoBlock> blocks;
    std::uint32_t color_pages = 0, mask_pages = 0;
};
/// Throws Error(damaged) for a photo with more levels than shaders hold.
PhotoBlocks lay_out_photos(std::span<const package::PhotoRecord> photos);

}  // namespace vantage
