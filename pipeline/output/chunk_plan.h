#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "scene/package/package_format.h"
#include "scene/package/package_reader.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// The sizes that determine a package's layout, in addition to its photos.
struct LayoutSizes {
    /// Bytes of the scene chunks whose size is not in SCEN, such as META; 0 if there is no chunk.
    std::map<package::Type, std::uint64_t> bytes;
    bool colors;  ///< whether the mesh has vertex colors
    std::uint64_t point_blocks = 0;
    bool coordinates = true;  ///< whether photos have texture coordinates per vertex
};
/// The sizes for a package that is rewritten.
LayoutSizes layout_sizes(const PackageReader& package, std::uint64_t meta_bytes, bool coordinates);

/// Whether photos get texture coordinates per vertex: in a compact package, only if they are the default or
/// if `asked` is set.
bool stores_coordinates(const package::SceneRecord& scene, bool asked);

/// Every chunk in file order, coarse before fine; for a shard, only the per-photo chunks of its photos. Space
/// is also reserved for photos that were skipped.
std::vector<ChunkPlan> plan_chunks(const package::SceneRecord& scene, const LayoutSizes& sizes,
                                   std::span<const package::PhotoRecord> photos, Share share = {});
}  // namespace vantage
