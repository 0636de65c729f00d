#include "pipeline/stages/cut_tile.h"

#include <algorithm>
#include <cstring>

#include "base/values/grid.h"

namespace vantage {

void cut_tile(std::span<const std::byte> texels, const Level& level, std::size_t number,
              std::span<std::byte> tile) {
    const int row = int(number) / level.columns(), column = int(number) % level.columns();
    const int x0 = column * tile_content - tile_border;
    const int first = std::max(0, -x0), last = std::min(tile_size, level.width - x0);
    const Grid<const std::byte> rows{texels.data(), 4 * level.width, level.height};
    std::byte* to = tile.data();
    for (int y = 0; y < tile_size; ++y, to += tile_size * 4) {
        const int sy = std::clamp(row * tile_content + y - tile_border, 0, level.height - 1);
        const std::byte* from = rows.row(sy).data();
        for (int x = 0; x < first; ++x) std::memcpy(to + 4 * x, from, 4);
        std::memcpy(to + 4 * first, from + 4 * std::size_t(x0 + first), 4 * std::size_t(last - first));
        for (int x = last; x < tile_size; ++x)
            std::memcpy(to + 4 * x, from + 4 * std::size_t(level.width - 1), 4);
    }
}

}  // namespace vantage
