#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/agreement/shared_discs.h"
#include "scene/package/package_format.h"

namespace vantage {

// What photos decide together, each band decides by itself: as if the photos of other bands had no pixels.

/// 1 + the highest number of a photo's band.
std::uint32_t band_count(std::span<const package::PhotoRecord> photos);

/// The records, those of photos of other bands without levels.
std::vector<package::PhotoRecord> records_of_band(std::span<const package::PhotoRecord> photos,
                                                  std::uint32_t band);

/// The samples, none for photos of other bands.
std::vector<std::span<const package::SampleRecord>> samples_of_band(
    Samples samples, std::span<const package::PhotoRecord> photos, std::uint32_t band);

}  // namespace vantage
