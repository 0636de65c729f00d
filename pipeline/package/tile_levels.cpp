#include "pipeline/package/tile_levels.h"

#include <cstring>

#include "pipeline/pixels/pyramid.h"

namespace vantage {

void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size) {
    writer.write_blocks(type, photo, level, [&](std::size_t number, std::span<std::byte> tile) {
        cut_tile(texels, size, number, tile);
    });
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

}  // namespace vantage
