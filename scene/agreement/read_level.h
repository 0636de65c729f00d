#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/values/rgba_image.h"
#include "base/values/tiling.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The finest level that has weight maps and at most `long_side` texels on its longer side; if there is none,
/// the coarsest level.
int coarse_level(const package::PhotoRecord& record, int long_side);

/// Copies a tile without its border to its place in `out`, which holds the level's width * height texels of 4
/// bytes. `texels`: the packed texels of `given`, a part of the tile that must contain the whole tile except
/// its border.
void copy_content(std::span<const std::byte> texels, const TilePart& given, const Level& level,
                  std::size_t tile, std::span<std::byte> out);

/// Assembles a level from its tiles: width * height texels of 4 bytes. Throws Error(damaged) if the chunk's
/// tiles do not match the level's size, or if a tile does not match its checksum.
std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& chunk,
                                  const Level& level);

/// Assembles a level of a photo's TILE, MASK or DPTH, as join_tiles() does, and releases the chunk's memory.
/// Also throws Error(damaged) if the chunk is missing.
std::vector<std::byte> read_level(const PackageReader& reader, const package::PhotoRecord& record,
                                  std::uint32_t photo, package::Type type, int level);

/// A level of a photo's TILE or MASK as an image. Throws whatever read_level() throws.
RgbaImage read_level_image(const PackageReader& reader, const package::PhotoRecord& record,
                           std::uint32_t photo, package::Type type, int level);

/// A level of a photo's color as seen by a pinhole camera. Throws whatever read_level() throws.
RgbaImage read_pinhole_level(const PackageReader& reader, const package::PhotoRecord& record,
                             std::uint32_t photo, int level);

/// The linear light, 0 to 1, of a photo as seen by a pinhole camera, at a level of the tiles or of the weight
/// maps; NaN where the photo has no opaque pixel. If a photo has a single level, its weight maps have half
/// its size, so only every second pixel is used. Throws whatever read_level() throws.
std::vector<std::array<float, 3>> read_linear_colors(const PackageReader& reader,
                                                     const package::PhotoRecord& record, std::uint32_t photo,
                                                     int level);

}  // namespace vantage
