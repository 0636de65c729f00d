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

/// The finest level with at most `long_side` texels on its longer side that has weight maps, or the coarsest.
int coarse_level(const package::PhotoRecord& record, int long_side);

/// Copies a tile without its border to the level's `out`, width * height texels of 4 bytes. `texels`: the
/// packed texels of the tile's part `given`, which must contain that area.
void copy_content(std::span<const std::byte> texels, const TilePart& given, const Level& level,
                  std::size_t tile, std::span<std::byte> out);

/// Assembles a level from its tiles: width * height texels of 4 bytes. Throws Error(damaged) if the chunk's
/// tiles do not match the level's size, or a tile its checksum.
std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& chunk,
                                  const Level& level);

/// The same for a level of a photo's TILE, MASK or DPTH; the chunk's memory is released. Also throws
/// Error(damaged) if the chunk is missing.
std::vector<std::byte> read_level(const PackageReader& reader, const package::PhotoRecord& record,
                                  std::uint32_t photo, package::Type type, int level);

/// A level of a photo's TILE or MASK as an image. Throws like read_level.
RgbaImage read_level_image(const PackageReader& reader, const package::PhotoRecord& record,
                           std::uint32_t photo, package::Type type, int level);

/// A level of a photo's color as seen by a pinhole camera. Throws like read_level.
RgbaImage read_pinhole_level(const PackageReader& reader, const package::PhotoRecord& record,
                             std::uint32_t photo, int level);

/// Linear light, 0 to 1, of a photo as seen by a pinhole camera, at a level of tiles or of weight maps; NaN
/// where it has no opaque pixel. A photo with a single level, whose weight maps have half its size, is
/// subsampled to every second pixel. Throws like read_level.
std::vector<std::array<float, 3>> read_linear_colors(const PackageReader& reader,
                                                     const package::PhotoRecord& record, std::uint32_t photo,
                                                     int level);

}  // namespace vantage
