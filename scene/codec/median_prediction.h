#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "base/values/grid.h"

namespace vantage::codec {

/// The median edge detector of LOCO-I (Weinberger et al. 2000): predicts a texel from its neighbors to the
/// left, above, and above left. The prediction continues the plane through these neighbors, except at an
/// edge.
inline int predicted(int left, int above, int corner) {
    return std::max(std::min(left, above), std::min(std::max(left, above), left + above - corner));
}

/// Sets each texel, row by row, to `next(expected)`. In the first row, the expected value is the texel to the
/// left, or 0 for the first texel. In the first column, it is the texel above.
template <class T, class Next>
void predict_each(const Grid<T>& values, const Next& next) {
    for (int y = 0; y < values.height; ++y) {
        T* row = &values(0, y);
        const T* above = y ? row - values.width : nullptr;
        row[0] = next(above ? int(above[0]) : 0);
        for (int x = 1; x < values.width; ++x)
            row[x] =
                next(above ? predicted(int(row[x - 1]), int(above[x]), int(above[x - 1])) : int(row[x - 1]));
    }
}

/// The texels of row `y` minus the values that predict_each() expects there.
template <class T>
void differences_of_row(const Grid<const T>& values, int y, std::span<std::int16_t> out) {
    const T* row = &values(0, y);
    const int n = values.width;
    if (y == 0) {
        out[0] = std::int16_t(row[0]);
        for (int x = 1; x < n; ++x) out[std::size_t(x)] = std::int16_t(int(row[x]) - int(row[x - 1]));
        return;
    }
    const T* above = row - n;
    out[0] = std::int16_t(int(row[0]) - int(above[0]));
    for (int x = 1; x < n; ++x)
        out[std::size_t(x)] =
            std::int16_t(int(row[x]) - predicted(int(row[x - 1]), int(above[x]), int(above[x - 1])));
}

/// Maps differences to unsigned numbers in order of magnitude: 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
inline std::uint32_t folded(std::int32_t d) { return std::uint32_t(d) << 1 ^ std::uint32_t(d >> 31); }
inline std::int32_t unfolded(std::uint32_t u) { return std::int32_t(u >> 1) ^ -std::int32_t(u & 1); }

}  // namespace vantage::codec
