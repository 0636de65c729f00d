#include "player/stream/stream_request.h"

#include "base/values/tiling.h"

namespace vantage {

std::uint64_t StreamRequest::size() const {
    if (bytes) return bytes;
    if (resource == Resource::points) return chunk->block_length;
    return second ? 2 * tile_bytes : tile_bytes;
}

std::vector<TilePlace> tiles_of(const PackageReader& package, const StreamRequest& r) {
    if (r.resource != Resource::color && r.resource != Resource::weight_maps) return {};
    const package::PhotoRecord& p = package.photos()[r.chunk->photo];
    const Level level = level_size(int(p.width), int(p.height), int(r.chunk->level));
    std::vector<TilePlace> out{{r.chunk, level, r.block}};
    if (r.second) out.push_back({r.second, level, r.block});
    return out;
}

}  // namespace vantage
