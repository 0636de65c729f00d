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

/// Cuts a level of 4-byte texels into its tiles, into the package.
void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size);

/// Puts the tiles of a level together again: width * height texels of 4 bytes. Throws Error(damaged) where
/// the chunk has not the tiles of that size.
std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& chunk,
                                  const Level& level);

/// The same of a photo's TILE, MASK or DPTH; their memory goes back to the system. Throws Error(damaged)
/// where they are missing, too.
std::vector<std::byte> read_level(const PackageReader& reader, const package::PhotoRecord& record,
                                  std::uint32_t photo, package::Type type, int level);
/// Colours or masks.
RgbaImage read_level_image(const PackageReader& reader, const package::PhotoRecord& record,
                           std::uint32_t photo, package::Type type, int level);

}  // namespace vantage
