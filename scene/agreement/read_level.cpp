#include "scene/agreement/read_level.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/text/error.h"
#include "base/values/srgb.h"
#include "scene/package/contents/pinhole_image.h"
#include "scene/package/contents/stored_tile.h"

namespace vantage {

int coarse_level(const package::PhotoRecord& r, int long_side) {
    int l = weight_map_level;
    while (l + 1 < int(r.levels) && int(std::max(r.width, r.height)) >> l > long_side) ++l;
    return l;
}

void copy_content(std::span<const std::byte> texels, const TilePart& given, const Level& level,
                  std::size_t tile, std::span<std::byte> out) {
    const int left = tile_left(level, tile) + tile_border, top = tile_top(level, tile) + tile_border;
    const auto bytes = 4 * std::size_t(std::min(tile_content, level.width - left));
    for (int y = 0; y < std::min(tile_content, level.height - top); ++y) {
        const std::size_t from = std::size_t(y + tile_border - given.top) * std::size_t(given.width()) +
                                 std::size_t(tile_border - given.left),
                          to = std::size_t(top + y) * std::size_t(level.width) + std::size_t(left);
        std::memcpy(&out[4 * to], &texels[4 * from], bytes);
    }
}

std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& e,
                                  const Level& level) {
    const auto whole = reader.raw(e);
    const Held held = reader.hold({&whole, 1});
    if (!holds_level(reader, e, level))
        throw Error(Exit::damaged, describe(e, reader) + ": tiles do not match the level's size");
    std::vector<std::byte> out(std::size_t(level.width) * std::size_t(level.height) * 4), tile(tile_bytes);
    for (std::size_t t = 0; t < std::size_t(level.tiles()); ++t) {
        if (!read_tile(reader, e, level, t, tile))
            throw DamagedPackage(Defect::tile_checksum,
                                 reader.path().string() + ": " + describe_damaged_tile(reader, e, level, t));
        copy_content(tile, {0, 0, tile_size, tile_size}, level, t, out);
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

RgbaImage read_level_image(const PackageReader& reader, const package::PhotoRecord& r, std::uint32_t photo,
                           package::Type type, int level) {
    const Level size = level_size(int(r.width), int(r.height), level);
    const std::vector<std::byte> texels = read_level(reader, r, photo, type, level);
    RgbaImage image{size.width, size.height, {}};
    image.rgba.resize(texels.size());
    std::memcpy(image.rgba.data(), texels.data(), texels.size());
    return image;
}

RgbaImage read_pinhole_level(const PackageReader& reader, const package::PhotoRecord& r, std::uint32_t photo,
                             int level) {
    RgbaImage image = read_level_image(reader, r, photo, package::Type::tiles, level);
    const auto lens = lens_table(reader, r, photo);
    return lens ? pinhole_image(image, *lens, level) : image;
}

std::vector<std::array<float, 3>> read_linear_colors(const PackageReader& reader,
                                                     const package::PhotoRecord& r, std::uint32_t photo,
                                                     int level) {
    const int stored = std::clamp(level, 0, std::max(int(r.levels) - 1, 0)), finer = level - stored;
    const RgbaImage image = read_pinhole_level(reader, r, photo, stored);
    const Level from = level_size(int(r.width), int(r.height), stored),
                to = level_size(int(r.width), int(r.height), level);
    std::vector<std::array<float, 3>> out;
    out.reserve(std::size_t(to.width) * std::size_t(to.height));
    for (int y = 0; y < to.height; ++y) {
        const std::uint8_t* row =
            &image.rgba[4 * std::size_t(std::min(y << finer, from.height - 1)) * std::size_t(from.width)];
        for (int x = 0; x < to.width; ++x) {
            const std::uint8_t* color = row + 4 * std::min(x << finer, from.width - 1);
            std::array<float, 3>& linear = out.emplace_back();
            for (std::size_t c = 0; c < 3; ++c)
                linear[c] = color[3] == 255 ? float(linear_of_srgb_byte()[color[c]])
                                            : std::numeric_limits<float>::quiet_NaN();
        }
    }
    return out;
}

}  // namespace vantage
