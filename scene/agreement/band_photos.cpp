#include "scene/agreement/band_photos.h"

#include <algorithm>

namespace vantage {

std::uint32_t band_count(std::span<const package::PhotoRecord> photos) {
    std::uint32_t count = 1;
    for (const package::PhotoRecord& p : photos) count = std::max(count, p.band + 1);
    return count;
}

std::vector<package::PhotoRecord> records_of_band(std::span<const package::PhotoRecord> photos,
                                                  std::uint32_t band) {
    std::vector<package::PhotoRecord> out(photos.begin(), photos.end());
    for (package::PhotoRecord& p : out)
        if (p.band != band) p.levels = 0;
    return out;
}

std::vector<std::span<const package::SampleRecord>> samples_of_band(
    Samples samples, std::span<const package::PhotoRecord> photos, std::uint32_t band) {
    std::vector<std::span<const package::SampleRecord>> out(samples.begin(), samples.end());
    for (std::size_t i = 0; i < out.size(); ++i)
        if (photos[i].band != band) out[i] = {};
    return out;
}

}  // namespace vantage
