#pragma once
#include <cstddef>
#include <cstdint>

#include "base/values/tiling.h"

/// Locations, bits and layouts that C++ and GLSL share.
namespace vantage::shader {

using uint = std::uint32_t;
using vec4 = float[4];
using uvec4 = std::uint32_t[4];
using mat4 = float[16];  ///< column-major

#include "shaders/contract.glsl"

// In std140 (and in std430, except for PointSizes and TransparentFragment), vectors are aligned to 16 bytes,
// and sizes are multiples of 16.
static_assert(offsetof(Photo, focal_center) == 64 && offsetof(Photo, color_base) == 176);
static_assert(sizeof(PointSizes) == 16);
static_assert(sizeof(TransparentFragment) == 20);
static_assert(sizeof(Photo) == 176 + 2 * 4 * level_count && sizeof(Photo) % 16 == 0);

static_assert(tile_texels == tile_size && tile_border_texels == tile_border &&
              tile_content_texels == tile_content && first_weight_level == weight_map_level);

}  // namespace vantage::shader
