#include "scene/agreement/image_set_photos.h"

#include <algorithm>

namespace vantage {

std::uint32_t image_set_count(std::span<const package::PhotoRecord> photos) {
    std::uint32_t count = 1;
    for (const package::PhotoRecord& p : photos) count = std::max(count, p.image_set + 1);
    return count;
}

std::vector<package::PhotoRecord> records_of_image_set(std::span<const package::PhotoRecord> photos,
                                                       std::uint32_t image_set) {
    std::vector<package::PhotoRecord> out(photos.begin(), photos.end());
    for (package::PhotoRecord& p : out)
        if (p.image_set != image_set) p.levels = 0;
    return out;
}

std::vector<std::span<const package::SampleRecord>> samples_of_image_set(
    Samples samples, std::span<const package::PhotoRecord> photos, std::uint32_t image_set) {
    std::vector<std::span<const package::SampleRecord>> out(samples.begin(), samples.end());
    for (std::size_t i = 0; i < out.size(); ++i)
        if (photos[i].image_set != image_set) out[i] = {};
    return out;
}

}  // namespace vantage
