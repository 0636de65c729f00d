#include "scene/middle_photo.h"

#include <vector>

namespace vantage {

std::uint32_t middle_photo(std::span<const package::PhotoRecord> photos, std::uint32_t band) {
    std::vector<std::uint32_t> own;
    for (std::uint32_t p = 0; p < photos.size(); ++p)
        if (photos[p].band == band) own.push_back(p);
    return own.empty() ? std::uint32_t(photos.size() / 2) : own[own.size() / 2];
}

}  // namespace vantage
