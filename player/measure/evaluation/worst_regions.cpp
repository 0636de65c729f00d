#include "player/measure/evaluation/worst_regions.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "player/measure/evaluation/picture_metrics.h"

namespace vantage {
namespace {

constexpr double least_share = 0.01;    ///< fraction of the squared error
constexpr double brightest_rms = 40.0;  ///< gray levels

WorstRegion worst_region(const CauseMap& map, Cause cause) {
    const Cells& cells = map.cells;
    const int columns = cells.columns(), rows = cells.rows();
    Integral sums(columns, rows);
    for (std::size_t c = 0; c < cells.count(); ++c)
        sums.add(int(c) % columns, int(c) / columns, map.squares[c].of(cause));
    const int side = std::max(1, searched_side(cells.width, cells.height) / cell_size);
    Place p{0, 0, std::min(side, columns), std::min(side, rows)}, worst = p;
    for (p.y = 0; p.y + p.height <= rows; ++p.y)
        for (p.x = 0; p.x + p.width <= columns; ++p.x)
            if (sums.over(p) > sums.over(worst)) worst = p;
    const Place pixels{worst.x * cell_size, worst.y * cell_size,
                       std::min(cells.width - worst.x * cell_size, worst.width * cell_size),
                       std::min(cells.height - worst.y * cell_size, worst.height * cell_size)};
    return {cause, pixels, sums.over(worst)};
}

/// Covers a part of a picture with gray.
void cover(Picture& picture, const Place& p) {
    for (int y = p.y; y < p.y + p.height; ++y)
        for (int x = p.x; x < p.x + p.width; ++x) {
            std::uint8_t* pixel =
                &picture.rgba[4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))];
            std::fill_n(pixel, 3, std::uint8_t(128));
        }
}

}  // namespace

std::vector<WorstRegion> worst_regions(const CauseMap& map, std::size_t most) {
    const CauseSquares totals = map.totals();
    std::vector<WorstRegion> out;
    for (const CauseRow& row : cause_table()) {
        const double all = is_hole(row.cause) ? totals.all() : totals.colored();
        const WorstRegion r = worst_region(map, row.cause);
        if (r.squares > 0 && r.squares >= least_share * all) out.push_back(r);
    }
    std::ranges::stable_sort(out, std::ranges::greater{}, &WorstRegion::squares);
    if (out.size() > most) out.erase(out.begin() + std::ptrdiff_t(most), out.end());
    return out;
}

Picture region_picture(const CauseMap& map, const WorstRegion& region, const Picture& photo,
                       const Picture& shown, std::span<const Picture> alone) {
    Picture difference = difference_picture(photo, shown, {});
    for (std::size_t cell = 0; cell < map.cells.count(); ++cell)
        if (map.squares[cell].of(region.cause) == 0) cover(difference, map.cells.place(cell));
    std::vector<const Picture*> pictures{&photo, &shown, &difference};
    for (std::size_t i = 0; i < std::min<std::size_t>(2, alone.size()); ++i) pictures.push_back(&alone[i]);
    return side_by_side(pictures, region.place);
}

Picture cause_picture(const CauseMap& map) {
    Picture out{map.cells.columns(), map.cells.rows(), {}, {}};
    for (std::size_t cell = 0; cell < map.cells.count(); ++cell) {
        const auto& squares = map.squares[cell];
        const auto most = std::size_t(std::ranges::max_element(squares) - squares.begin());
        const Place p = map.cells.place(cell);
        const double rms = std::sqrt(squares.all() / (3.0 * p.width * p.height)),
                     light = std::min(rms / brightest_rms, 1.0);
        for (const std::uint8_t v : cause_table()[most].color)
            out.rgba.push_back(std::uint8_t(std::lround(light * v)));
        out.rgba.push_back(255);
    }
    return out;
}

}  // namespace vantage
