#include "agreement/read_level.h"

#include <algorithm>
#include <cstring>

#include "scene/error.h"

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
    std::vector<std::byte> out(std::size_t(level.width) * std::size_t(level.height) * 4);
    for (int y = 0; y < level.height; ++y)
        for (int column = 0; column < level.columns(); ++column) {
            const int tile = (y / tile_content) * level.columns() + column, x = column * tile_content;
            const int n = std::min(tile_content, level.width - x);
            const auto from = reader.block(e, std::size_t(tile));
            std::memcpy(
                out.data() + (std::size_t(y) * std::size_t(level.width) + std::size_t(x)) * 4,
                from.data() + (std::size_t(y % tile_content + tile_border) * tile_size + tile_border) * 4,
                std::size_t(n) * 4);
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

}  // namespace vantage
