#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "player/photo_block.h"
#include "player/tile_cache.h"
#include "player/view.h"
#include "scene/package_format.h"

namespace vantage {

/// Clusters whose bounding sphere reaches into the view: never one too few.
std::vector<std::uint32_t> clusters_in_view(std::span<const package::ClusterRecord> clusters,
                                            const View& view);

/// Nearest and farthest linear depth of the clusters' spheres, kept to a ratio that a float depth buffer
/// resolves. {0, 0} when all are behind the viewer.
Eigen::Vector2d depth_range(std::span<const package::ClusterRecord> clusters, const View& view);

/// Tiles of one photo, by level; each list ascending, without doubles.
struct TileNeeds {
    std::array<std::vector<std::uint32_t>, most_levels> color;
    std::vector<std::uint32_t> masks;
    std::size_t tiles() const;
};

/// The tiles that colour the clusters `in_view`: from the level whose texels are as fine as the view's
/// samples up to the coarsest, which stands in for what is not loaded. Where `coverage` is given, a cluster
/// needs what its record says the photo sees of it (per-vertex coordinates); without, all that its sphere
/// could touch (per fragment).
TileNeeds tile_needs(const package::PhotoRecord& photo, std::span<const package::ClusterRecord> clusters,
                     std::span<const package::CoverageRecord> coverage,
                     std::span<const std::uint32_t> in_view, const View& view, int samples);

/// The needs as requests to the caches, coarse before fine.
struct TileRequests {
    std::vector<TileRequest> color, masks, depth;
};
void append_requests(const PackageReader& package, std::uint32_t photo, const PhotoBlock& pages,
                     const TileNeeds& needs, TileRequests& out);

}  // namespace vantage
