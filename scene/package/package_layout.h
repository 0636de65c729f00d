#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// The type and size of a chunk that is yet to be written.
struct ChunkPlan {
    package::Type type;
    std::uint32_t photo = package::scene_wide;
    std::uint32_t level = 0;
    std::uint64_t bytes = 0;  ///< length of the head, for a chunk without blocks
    std::uint64_t blocks = 0;
    std::uint64_t block_length = 0;
    bool compact = false;  ///< the chunk may be stored in a shorter form; the sizes are those of the raw form
};

/// The shard that one of several runs prepares: number `share`, counted from 1, of `shares`. If both are 0,
/// the run prepares all photos.
struct Share {
    std::uint32_t share = 0, shares = 0;
    bool holds(std::size_t photo) const { return shares == 0 || photo % shares == share - 1; }
};

/// The positions of the planned chunks in the package or, if some chunks are compact, in its part file.
/// There, each chunk has space for its raw form; most of this space is never written.
struct PackageLayout {
    std::uint64_t bytes = 0;          ///< size of the file
    std::uint64_t compact_bytes = 0;  ///< bytes of the file reserved for the raw forms of compact chunks
    std::uint64_t checksum = 0;       ///< checksum of the photos' names and their chunks' positions
    std::vector<package::DirectoryEntry> directory;  ///< entries in the order of the plan, without checksums

    bool compact() const { return compact_bytes > 0; }
};

/// `names` is a checksum of the photos' names, in order.
PackageLayout package_layout(std::span<const ChunkPlan> plan, std::uint64_t names);

}  // namespace vantage
