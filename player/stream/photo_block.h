#pragma once
#include <cstdint>

#include "player/plan/tile_needs.h"
#include "scene/package_format.h"

namespace vantage {

/// A photo as shaders/photos.glsl reads it (std430).
struct PhotoBlock {
    float cam_from_origin[16];  ///< column by column
    float focal_center[4];
    float size_weight[4];
    float center_hull[4];
    float direction_presence[4];
    float thumbnail[4];
    float false_color[4];
    float gain[4];
    float falloff[4];
    std::uint32_t color_base[most_levels], mask_base[most_levels];
};
static_assert(sizeof(PhotoBlock) == 288);

/// What of a photo does not change from frame to frame; no thumbnail, nothing resident, presence 1.
PhotoBlock make_photo_block(const package::PhotoRecord& photo, std::uint32_t index);

/// A colour by which people tell photo `index` from others, sRGB in [0, 1].
struct FalseColor {
    float r, g, b;
};
FalseColor false_color(std::uint32_t index);

}  // namespace vantage
