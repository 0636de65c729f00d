// Measures how much tiles must overlap their neighbors.
#include <array>
#include <random>

#include "base/values/tiling.h"
#include "player/measure/evaluation/photo_pixels.h"
#include "tests/bench/scenes/crop.h"
#include "tests/bench/sweeps/sweep.h"
#include "tests/bench/sweeps/tiles/tile_pixels.h"

namespace vantage::bench {
namespace {

/// A level cut into tiles of 256x256 texels; on each side, `border` texels belong to the neighbors.
struct Cut {
    int content, columns;
    std::vector<Picture> tiles;
};

Cut cut_all(const Picture& image, int border) {
    const int content = tile_size - 2 * border;
    Cut out{content, (image.width + content - 1) / content, {}};
    for (int y = 0; y < image.height; y += content)
        for (int x = 0; x < image.width; x += content)
            out.tiles.push_back(crop(image, x - border, y - border, tile_size, tile_size));
    return out;
}

/// Samples all four channels bilinearly, clamped at the edges of the image.
std::array<double, 4> bilinear(const Picture& image, double x, double y) {
    const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5), s = x - 0.5 - fx, t = y - 0.5 - fy;
    const auto at = [&](int i, int j) {
        return texel(image, std::clamp(int(fx) + i, 0, image.width - 1),
                     std::clamp(int(fy) + j, 0, image.height - 1));
    };
    std::array<double, 4> out;
    for (std::size_t c = 0; c < 4; ++c)
        out[c] = (1 - t) * ((1 - s) * at(0, 0)[c] + s * at(1, 0)[c]) +
                 t * ((1 - s) * at(0, 1)[c] + s * at(1, 1)[c]);
    return out;
}

/// Compares samples of the tiles with samples of the whole image at random positions.
void compare(const Picture& whole, int border, std::size_t points, Differences& all) {
    const Cut tiles = cut_all(whole, border);
    std::mt19937 engine(3);
    // Positions are multiples of 1/256 texel, as on graphics cards, so that rounding has no effect.
    const auto place = [&](int length) { return double(engine() % (std::uint32_t(length) * 256)) / 256; };
    for (std::size_t i = 0; i < points; ++i) {
        const double x = place(whole.width), y = place(whole.height);
        const int column = int(x) / tiles.content, row = int(y) / tiles.content;
        const auto truth = bilinear(whole, x, y);
        if (truth[3] < 255) continue;
        const auto found = bilinear(tiles.tiles[std::size_t(row * tiles.columns + column)],
                                    x - column * tiles.content + border, y - row * tiles.content + border);
        for (std::size_t c = 0; c < 3; ++c) all.add(found[c] - truth[c]);
    }
}

std::vector<Measurement> measure_borders(const BenchScene& scene, const Effort& effort) {
    const PackageReader package(scene.package);
    constexpr int borders[] = {0, 1, 2, 4, 8};
    std::array<Differences, std::size(borders)> all;
    for (const std::uint32_t photo : some_photos(package, effort.photos)) {
        const Picture whole = photo_at_level(package, photo, 0);
        for (std::size_t b = 0; b < std::size(borders); ++b)
            compare(whole, borders[b], effort.points, all[b]);
    }
    if (all[0].empty()) return {};
    std::vector<Measurement> out;
    for (std::size_t b = 0; b < std::size(borders); ++b) {
        const double share = double(tile_size) / (tile_size - 2 * borders[b]);
        Measurement m;
        m.curve = "border";
        m.setting = std::to_string(borders[b]);
        m.exact = borders[b] >= 1;  // bilinear samples reach half a texel beyond the tile's own
        m.chosen = borders[b] == tile_border;
        m.values = {{"psnr", all[b].psnr()}, {"worst", all[b].worst()}, {"texel_bytes", 4 * share * share}};
        out.push_back(std::move(m));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path&) {
    return {{"all", [=, &scene] { return measure_borders(scene, effort); }}};
}

}  // namespace

extern const Sweep tile_border_sweep;
const Sweep tile_border_sweep{"tile-border",
                              "Overlap of tiles",
                              "Samples at the edge of a tile need texels of its neighbors. How many?",
                              "samples of the whole photo",
                              "0 of 255",
                              {{"texel_bytes", "psnr"}, {"texel_bytes", "worst"}},
                              jobs};

}  // namespace vantage::bench
