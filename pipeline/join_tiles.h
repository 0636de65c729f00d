#pragma once
#include <cstddef>
#include <vector>

#include "scene/package_reader.h"
#include "scene/tiling.h"

namespace vantage {

/// Puts the tiles of a level together again: width * height texels of 4 bytes. Throws Error(damaged) where
/// the chunk has not the tiles of that size.
std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& chunk,
                                  const Level& level);

}  // namespace vantage
