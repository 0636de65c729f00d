#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "scene/package_reader.h"
#include "scene/tiling.h"

namespace vantage {

/// Whether a chunk of tiles (TILE, MASK, DPTH) is stored in a known form and has the tiles of this level.
bool holds_level(const PackageReader& package, const package::DirectoryEntry& chunk, const Level& level);

/// Copies or decodes a tile with its border into tile_bytes; false if it is damaged. Only what the tile needs
/// is read. The chunk must hold the level. Thread-safe.
bool read_tile(const PackageReader& package, const package::DirectoryEntry& chunk, const Level& level,
               std::size_t tile, std::span<std::byte> to);

/// The bytes in the package that read_tile() reads, several pieces at most for color in cells.
std::vector<std::span<const std::byte>> stored_pieces(const PackageReader& package,
                                                      const package::DirectoryEntry& chunk,
                                                      const Level& level, std::size_t tile);

/// A photo's thumbnail: width * height * 4 bytes, RGBA. False if it is damaged.
bool read_thumbnail(const PackageReader& package, std::uint32_t photo, std::span<std::byte> to);

/// What is wrong with a tile, for a message: "TILE of photo 3 (00003.jpg), level 2: tile 5 of 12: ...".
std::string describe_damaged_tile(const PackageReader& package, const package::DirectoryEntry& chunk,
                                  const Level& level, std::size_t tile);

}  // namespace vantage
