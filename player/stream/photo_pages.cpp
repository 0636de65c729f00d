#include "player/stream/photo_pages.h"

#include <algorithm>
#include <string>

#include "base/text/error.h"
#include "base/values/tiling.h"
#include "shaders/contract.h"

namespace vantage {

using package::Type;

PackagePages number_pages(std::span<const package::PhotoRecord> photos) {
    PackagePages out;
    for (const package::PhotoRecord& p : photos) {
        if (p.levels > max_levels)
            throw Error(Exit::damaged, std::string(p.name) + ": has " + std::to_string(p.levels) +
                                           " levels, expected at most " + std::to_string(max_levels));
        PhotoPages pages;
        pages.color_first = out.color;
        pages.weight_map_first = out.weight_maps;
        const auto tiles = [&](int level) {
            return std::uint32_t(level_size(int(p.width), int(p.height), level).tiles());
        };
        for (std::uint32_t l = 0; l < p.levels; ++l) {
            pages.color[l] = out.color;
            out.color += tiles(int(l));
        }
        for (int l = weight_map_level; p.levels && l < weight_map_levels_end(int(p.levels)); ++l) {
            pages.weight_maps[std::size_t(l)] = out.weight_maps;
            out.weight_maps += tiles(l);
        }
        pages.color_count = out.color - pages.color_first;
        pages.weight_map_count = out.weight_maps - pages.weight_map_first;
        out.photos.push_back(pages);
    }
    return out;
}

StreamRequest color_request(const PackageReader& package, const PackagePages& pages, std::uint32_t photo,
                            std::uint32_t level, std::uint32_t tile) {
    return {Resource::color, pages.photos[photo].color[level] + tile, package.find(Type::tiles, photo, level),
            tile};
}

StreamRequest weight_map_request(const PackageReader& package, const PackagePages& pages, std::uint32_t photo,
                                 std::uint32_t level, std::uint32_t tile) {
    StreamRequest r{Resource::weight_maps, pages.photos[photo].weight_maps[level] + tile,
                    package.find(Type::weight_maps, photo, level), tile};
    r.second = package.find(Type::depth, photo, level);
    return r;
}

std::uint32_t base_level(const package::PhotoRecord& photo) {
    return std::uint32_t(std::max(int(photo.levels) - shader::levels_of_base, 0));
}

std::uint32_t base_tiles(const package::PhotoRecord& photo) {
    return std::uint32_t(level_size(int(photo.width), int(photo.height), int(base_level(photo))).tiles());
}

StreamRequest thumbnail_request(const PackageReader& package, std::uint32_t photo) {
    StreamRequest r{Resource::thumbnail, photo, package.find(Type::thumbnail, photo)};
    const package::PhotoRecord& p = package.photos()[photo];
    r.bytes = std::uint64_t(p.thumbnail_width) * p.thumbnail_height * 4;
    return r;
}

}  // namespace vantage
