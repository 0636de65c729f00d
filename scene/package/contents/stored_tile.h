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

/// Copies or decodes a tile with its border into tile_bytes; false if it is damaged. Reads only the bytes of
/// the tile, and fetches them if the package is on a server; bytes that do not match their checksum are
/// fetched once more. The chunk must hold the level. Thread-safe. Throws Error(input) if the bytes cannot be
/// fetched, Error(storage), and Error(interrupted) when stopped.
bool read_tile(const PackageReader& package, const package::DirectoryEntry& chunk, const Level& level,
               std::size_t tile, std::span<std::byte> to, std::stop_token stop = {});

struct TilePlace {
    const package::DirectoryEntry* chunk;
    Level level;
    std::size_t tile;
};
/// If the package is on a server, fetches the bytes of these tiles in one batch. They stay readable as long
/// as the result lives. Throws like read_tile().
[[nodiscard]] Held hold_tiles(const PackageReader& package, std::span<const TilePlace> tiles,
                              std::stop_token stop);

/// The bytes in the package that read_tile() reads in addition to the chunk's head, which must be readable.
/// Only color in cells has several pieces.
std::vector<std::span<const std::byte>> stored_pieces(const PackageReader& package,
                                                      const package::DirectoryEntry& chunk,
                                                      const Level& level, std::size_t tile);

/// The photo's original JPEG, without metadata, from a level stored in cells. Empty if a cell is damaged. The
/// package must be a file, and the chunk must hold the level.
std::optional<std::vector<std::byte>> own_jpeg(const PackageReader& package,
                                               const package::DirectoryEntry& chunk);

/// A photo's thumbnail: width * height * 4 bytes, RGBA. False if it is damaged. Throws like read_tile().
bool read_thumbnail(const PackageReader& package, std::uint32_t photo, std::span<std::byte> to);

/// Describes the error in a tile, for a message: "TILE of photo 3 (00003.jpg), level 2: tile 5 of 12: ...".
std::string describe_damaged_tile(const PackageReader& package, const package::DirectoryEntry& chunk,
                                  const Level& level, std::size_t tile);

}  // namespace vantage
