#pragma once
#include <cstdint>

#include "player/plan/selection/tile_needs.h"
#include "scene/package/package_format.h"
#include "shaders/contract.h"

namespace vantage {

/// A photo's data in the shaders (std140).
using PhotoBlock = shader::Photo;
static_assert(shader::level_count == max_levels);

/// Sets the fields that do not change between frames, for a photo that has no resident data. `label`: see
/// BackgroundContent.
PhotoBlock make_photo_block(const package::PhotoRecord& photo, std::uint32_t index, std::uint8_t label = 0);

/// A color that distinguishes photo `index` from the others, sRGB in [0, 1].
struct FalseColor {
    float r, g, b;
};
FalseColor false_color(std::uint32_t index);

}  // namespace vantage
