#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/pixels/rgba_image.h"
#include "scene/package_reader.h"
#include "scene/package_writer.h"
#include "scene/tiling.h"

namespace vantage {

/// Cuts a level of 4-byte texels into tiles and writes them to the package.
void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size);

/// Joins the tiles of a level: width * height texels of 4 bytes. Throws Error(damaged) if the chunk's tiles
/// do not match the level's size.
std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& chunk,
                                  const Level& level);

/// The same for a level of a photo's TILE, MASK or DPTH; the chunk's memory is released. Also throws
/// Error(damaged) if the chunk is missing.
std::vector<std::byte> read_level(const PackageReader& reader, const package::PhotoRecord& record,
                                  std::uint32_t photo, package::Type type, int level);
/// The same as an image, for TILE and MASK.
RgbaImage read_level_image(const PackageReader& reader, const package::PhotoRecord& record,
                           std::uint32_t photo, package::Type type, int level);

}  // namespace vantage
