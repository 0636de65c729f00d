#include "player/evaluate/photo_pixels.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "agreement/read_level.h"
#include "scene/tiling.h"

namespace vantage {

Picture level_of_photo(const PackageReader& package, package::Type type, std::uint32_t photo, int level) {
    const package::PhotoRecord& record = package.photos()[photo];
    const package::DirectoryEntry* chunk = package.find(type, photo, std::uint32_t(level));
    if (!record.levels || !chunk) throw std::invalid_argument("no such level of a photo");
    const Level size = level_size(int(record.width), int(record.height), level);
    Picture p{size.width, size.height, {}, {}};
    p.rgba.resize(std::size_t(size.width) * std::size_t(size.height) * 4);
    std::ranges::copy(join_tiles(package, *chunk, size), std::as_writable_bytes(std::span(p.rgba)).begin());
    return p;
}

View view_of_level(const package::PhotoRecord& photo, int level) {
    return {intrinsics(photo).at_level(level), cam_from_origin(photo), exposure_of(photo)};
}

}  // namespace vantage
