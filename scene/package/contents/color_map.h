#pragma once
#include <array>
#include <cstdint>

namespace vantage {

/// Color maps from the lowest to the highest value. `automatic` means coolwarm if there are values of both
/// signs, otherwise viridis. Three maps increase evenly in lightness: viridis, magma (both by van der Walt
/// and Smith 2015) and cividis (Nunez, Anderton and Renslow 2018), which is also suitable for color-blind
/// viewers. Coolwarm (Moreland 2009) diverges from a light center. Each map is interpolated from 17 colors
/// and differs from the published table by at most 6 of 255 (cividis by 11, coolwarm by 9).
enum class ColorMap { automatic, viridis, magma, cividis, coolwarm, count };

using ColorTable = std::array<std::array<std::uint8_t, 4>, 256>;  ///< sRGB and alpha
/// Treats `automatic` as viridis. `center`: the position of the center of a diverging map, 0 to 1. Equal
/// distances from the center have equal strength, so the table lacks the colors beyond its nearer end.
ColorTable color_table(ColorMap map, double center = 0.5);

/// The map's name on the command line.
const char* name_of(ColorMap map);

/// The map that `automatic` selects.
ColorMap chosen_map(ColorMap map, double low, double high);

}  // namespace vantage
