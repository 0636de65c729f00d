#pragma once
#include <array>
#include <cstdint>

namespace vantage {

/// Color maps from the lowest to the highest value. Automatic: coolwarm if values have both signs, otherwise
/// viridis. Viridis and magma (van der Walt and Smith 2015) and cividis (Nunez, Anderton and Renslow 2018,
/// also for color-blind viewers) increase evenly in lightness; coolwarm (Moreland 2009) diverges from a light
/// center. Interpolated from 17 colors each: within 6 of 255 of the published tables (cividis 11, coolwarm
/// 9).
enum class ColorMap { automatic, viridis, magma, cividis, coolwarm, count };

using ColorTable = std::array<std::array<std::uint8_t, 4>, 256>;  ///< sRGB and alpha
/// Treats `automatic` as viridis.
ColorTable color_table(ColorMap map);

/// The map's name on the command line.
const char* name_of(ColorMap map);

/// The map that `automatic` selects.
ColorMap chosen_map(ColorMap map, double low, double high);

}  // namespace vantage
