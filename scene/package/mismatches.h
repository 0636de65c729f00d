#pragma once
#include <limits>
#include <string>
#include <vector>

#include "scene/package/damaged_package.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A chunk or tile that does not match its checksum.
struct Mismatch {
    Defect defect;  ///< chunk_checksum or tile_checksum
    std::string text;
};
/// The chunks whose heads do not match their checksums and, with `tiles`, the tiles that do not match theirs;
/// at most `most` mismatches. A package without mismatches is valid. Pages are released after they have been
/// read.
std::vector<Mismatch> mismatches(const PackageReader& package, bool tiles,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());
/// The message for a tile, or for a block of color in cells, that does not match its checksum.
std::string tile_mismatch(const PackageReader& package, const package::DirectoryEntry& entry,
                          std::size_t tile);
/// Reads the whole package. Throws Error(damaged) with the first mismatch.
void expect_valid(const PackageReader& package);

}  // namespace vantage
