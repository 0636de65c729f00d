#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package/package_format.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// What a package's layout depends on, besides its photos.
struct LayoutSizes {
    std::uint64_t meta_bytes;
    bool colors;  ///< the mesh has vertex colors
    std::uint64_t point_nodes = 0, point_blocks = 0;
    std::uint64_t image_sets = 0;  ///< 0 if the effect is off
    bool coordinates = true;       ///< photos have texture coordinates per vertex
};
/// Whether photos have texture coordinates per vertex: in a compact package only if they are shown by
/// default, or `asked` for.
bool stores_coordinates(const package::SceneRecord& scene, bool asked);

/// Every chunk in file order, coarse before fine; for a share, the per-photo chunks of its photos only. Space
/// is also reserved for photos that were skipped.
std::vector<ChunkPlan> plan_chunks(const package::SceneRecord& scene, const LayoutSizes& sizes,
                                   std::span<const package::PhotoRecord> photos, Share share = {});
}  // namespace vantage
