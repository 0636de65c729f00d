#include "pipeline/write_tiles.h"

#include "pipeline/stages/pyramid.h"

namespace vantage {

void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size) {
    writer.write_blocks(type, photo, level, [&](std::size_t number, std::span<std::byte> tile) {
        cut_tile(texels, size, number, tile);
    });
}

}  // namespace vantage
