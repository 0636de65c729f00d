#include "player/measure/evaluation/place.h"

#include <algorithm>
#include <cstring>

#include "base/values/grid.h"

namespace vantage {
namespace {

constexpr int gap = 4;  ///< px between pictures side by side

}

int searched_side(int width, int height) { return std::max(std::max(width, height) / 6, 48); }

Picture side_by_side(std::span<const Picture* const> pictures, const Place& p) {
    const int count = int(pictures.size());
    Picture out;
    out.width = count * p.width + std::max(0, count - 1) * gap;
    out.height = p.height;
    out.rgba.resize(std::size_t(out.width) * std::size_t(out.height) * 4, 0);
    int column = 0;
    const Grid<std::uint8_t> to{out.rgba.data(), 4 * out.width, out.height};
    for (const Picture* picture : pictures) {
        const Grid<const std::uint8_t> from{picture->rgba.data(), 4 * picture->width, picture->height};
        for (int y = 0; y < p.height; ++y)
            std::memcpy(&to(4 * column, y), &from(4 * p.x, p.y + y), 4 * std::size_t(p.width));
        column += p.width + gap;
    }
    return out;
}

}  // namespace vantage
