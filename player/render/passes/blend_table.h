#pragma once
#include <span>

#include "player/render/render_settings.h"

namespace vantage {

/// A blend mode is a row of the table in blend_table.cpp and a branch of weight_of() in shaders/blend.frag.
struct BlendRow {
    Blend blend;
    const char* name;    ///< on the command line
    const char* label;   ///< in the blending panel
    const char* help;    ///< the criterion for a photo's weight, for --help
    const char* define;  ///< preprocessor symbol of its weight, "" for the shader's default
    bool by_angle;   ///< its weight falls with the angle between the rays, so distant photos can be skipped
    bool takes_one;  ///< the color is that of the photo with the largest weight, not a weighted mean
};

/// In the order of the radio buttons and of the keys 1, 2, 3.
std::span<const BlendRow> blend_table();
const BlendRow& blend_row(Blend blend);
inline bool takes_one(Blend blend) { return blend_row(blend).takes_one; }

}  // namespace vantage
