#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "base/values/tiling.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Whether a chunk of tiles (TILE, MASK, DPTH) is stored in a known form and has the tiles of this level.
bool holds_level(const PackageReader& package, const package::DirectoryEntry& chunk, const Level& level);

/// Copies or decodes a tile, including its border (tile_bytes bytes in all), to `to`. Returns false if the
/// tile is damaged. Reads only the bytes of the tile and, if the package is on a server, fetches them; bytes
/// that do not match their checksum are fetched once more. The chunk must hold the level. Thread-safe. Throws
/// Error(input) if the bytes cannot be fetched, Error(storage) if the cache cannot be used, and
/// Error(interrupted) when stopped.
bool read_tile(const PackageReader& package, const package::DirectoryEntry& chunk, const Level& level,
               std::size_t tile, std::span<std::byte> to, std::stop_token stop = {});

struct TilePlace {
    const package::DirectoryEntry* chunk;
    Level level;
    std::size_t tile;
};
/// If the package is on a server, fetches the bytes of these tiles in one batch. The bytes stay readable as
/// long as the result lives. Throws whatever read_tile() throws.
[[nodiscard]] Held hold_tiles(const PackageReader& package, std::span<const TilePlace> tiles,
                              std::stop_token stop);

/// The bytes of the package that read_tile() reads in addition to the chunk's head. The head must be
/// readable. There are several pieces only for color that is stored in cells.
std::vector<std::span<const std::byte>> stored_pieces(const PackageReader& package,
                                                      const package::DirectoryEntry& chunk,
                                                      const Level& level, std::size_t tile);

/// The photo's original JPEG without its metadata, from a level that is stored in cells. Empty if a cell is
/// damaged. The package must be a file, and the chunk must hold the level.
std::optional<std::vector<std::byte>> own_jpeg(const PackageReader& package,
                                               const package::DirectoryEntry& chunk);

/// Reads a photo's thumbnail: width * height * 4 bytes, RGBA. Returns false if it is damaged. Throws whatever
/// read_tile() throws.
bool read_thumbnail(const PackageReader& package, std::uint32_t photo, std::span<std::byte> to);

/// The text of a message about an error in a tile: "TILE of photo 3 (00003.jpg), level 2: tile 5 of 12: ...".
std::string describe_damaged_tile(const PackageReader& package, const package::DirectoryEntry& chunk,
                                  const Level& level, std::size_t tile);

}  // namespace vantage
