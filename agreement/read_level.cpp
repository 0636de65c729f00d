#include "agreement/read_level.h"

#include <algorithm>
#include <limits>

#include "scene/error.h"
#include "values/srgb.h"

namespace vantage {

int coarse_level(const package::PhotoRecord& r, int long_side) {
    int l = mask_level;
    while (l + 1 < int(r.levels) && int(std::max(r.width, r.height)) >> l > long_side) ++l;
    return l;
}

std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& e,
                                  const Level& level) {
    if (reader.blocks(e) != std::size_t(level.tiles()) || e.block_length != tile_bytes)
        throw Error(Exit::damaged, describe(e, reader) + ": tiles do not match the level's size");
    for (std::size_t t = 0; t < reader.blocks(e); ++t) reader.sound_block(e, t);
    std::vector<std::byte> out;
    out.reserve(std::size_t(level.width) * std::size_t(level.height) * 4);
    for (int y = 0; y < level.height; ++y)
        for (int column = 0; column < level.columns(); ++column) {
            const int tile = (y / tile_content) * level.columns() + column, x = column * tile_content;
            const auto n = std::size_t(std::min(tile_content, level.width - x));
            const auto first = std::size_t(y % tile_content + tile_border) * tile_size + tile_border;
            const auto row = reader.block(e, std::size_t(tile)).subspan(4 * first, 4 * n);
            out.insert(out.end(), row.begin(), row.end());
        }
    return out;
}

std::vector<std::byte> read_level(const PackageReader& reader, const package::PhotoRecord& r,
                                  std::uint32_t photo, package::Type type, int level) {
    const package::DirectoryEntry* e = reader.find(type, photo, std::uint32_t(level));
    if (!e)
        throw Error(Exit::damaged, reader.path().string() + ": " + r.name + ": a pyramid level is missing");
    std::vector<std::byte> texels = join_tiles(reader, *e, level_size(int(r.width), int(r.height), level));
    reader.forget(reader.raw(*e));
    return texels;
}

std::vector<std::array<float, 3>> read_linear_colors(const PackageReader& reader,
                                                     const package::PhotoRecord& r, std::uint32_t photo,
                                                     int level) {
    const int stored = std::clamp(level, 0, std::max(int(r.levels) - 1, 0)), finer = level - stored;
    const auto rgba = read_level(reader, r, photo, package::Type::tiles, stored);
    const Level from = level_size(int(r.width), int(r.height), stored),
                to = level_size(int(r.width), int(r.height), level);
    std::vector<std::array<float, 3>> out;
    out.reserve(std::size_t(to.width) * std::size_t(to.height));
    for (int y = 0; y < to.height; ++y) {
        const std::byte* row =
            &rgba[4 * std::size_t(std::min(y << finer, from.height - 1)) * std::size_t(from.width)];
        for (int x = 0; x < to.width; ++x) {
            const std::byte* color = row + 4 * std::min(x << finer, from.width - 1);
            std::array<float, 3>& linear = out.emplace_back();
            for (std::size_t c = 0; c < 3; ++c)
                linear[c] = color[3] == std::byte(255)
                                ? float(linear_of_srgb_byte()[std::to_integer<std::size_t>(color[c])])
                                : std::numeric_limits<float>::quiet_NaN();
        }
    }
    return out;
}

}  // namespace vantage
