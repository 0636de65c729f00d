#include "player/evaluate/photo_pixels.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "scene/tiling.h"
#include "values/grid.h"

namespace vantage {

Picture level_of_photo(const PackageReader& package, package::Type type, std::uint32_t photo, int level) {
    const package::PhotoRecord& record = package.photos()[photo];
    const package::DirectoryEntry* chunk = package.find(type, photo, std::uint32_t(level));
    if (!record.levels || !chunk) throw std::invalid_argument("no such level of a photo");
    const Level size = level_size(int(record.width), int(record.height), level);
    Picture p{size.width, size.height, {}, {}};
    p.rgba.resize(std::size_t(size.width) * std::size_t(size.height) * 4);
    const Grid<std::uint8_t> out{p.rgba.data(), 4 * size.width, size.height};
    for (int t = 0; t < size.tiles(); ++t) {
        const Grid<const std::byte> texels{package.sound_block(*chunk, std::size_t(t)).data(), 4 * tile_size,
                                           tile_size};
        const int x0 = t % size.columns() * tile_content, y0 = t / size.columns() * tile_content;
        const int width = std::min(tile_content, size.width - x0),
                  height = std::min(tile_content, size.height - y0);
        for (int y = 0; y < height; ++y)
            std::memcpy(&out(4 * x0, y0 + y), &texels(4 * tile_border, y + tile_border),
                        std::size_t(width) * 4);
    }
    return p;
}

View view_of_level(const package::PhotoRecord& photo, int level) {
    return {intrinsics(photo).at_level(level), cam_from_origin(photo), exposure_of(photo)};
}

}  // namespace vantage
