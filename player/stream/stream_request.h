#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/agreement/transient_map.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Units of upload.
enum class Resource : std::uint32_t {
    color,        ///< a tile of color
    weight_maps,  ///< a tile of weight maps, followed by the tile of depth
    thumbnail,    ///< a photo's thumbnail
    coordinates,  ///< a piece of a photo's texture coordinates
    points,       ///< a block of points
};
inline constexpr std::size_t photo_resources = 4;  ///< all but points

/// A piece of the package to fetch. `key` is unique among the pieces of the same resource.
struct StreamRequest {
    Resource resource;
    std::uint32_t key;
    const package::DirectoryEntry* chunk;
    std::uint32_t block = 0;                          ///< number of the block, if the chunk has blocks
    std::uint64_t first = 0, bytes = 0;               ///< range in bytes, if the chunk has no blocks
    const package::DirectoryEntry* second = nullptr;  ///< chunk whose block of the same number is also read
    bool reweighted = false;                          ///< `weights` replaces stored transient weights
    const TransientMap* weights = nullptr;            ///< see set_weights

    /// Size in the upload ring; for tiles, the decoded size.
    std::uint64_t size() const;
    std::uint64_t identity() const { return std::uint64_t(resource) << 32 | key; }
};

/// The tiles that a request reads; none unless the request is for color or weight maps.
std::vector<TilePlace> tiles_of(const PackageReader& package, const StreamRequest& request);

}  // namespace vantage
