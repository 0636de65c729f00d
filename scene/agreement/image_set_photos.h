#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/agreement/shared_discs.h"
#include "scene/package/package_format.h"

namespace vantage {

// What photos decide together, each image set decides by itself: as if the photos of other image sets had no
// pixels.

/// 1 + the highest number of a photo's image set.
std::uint32_t image_set_count(std::span<const package::PhotoRecord> photos);

/// The records, those of photos of other image sets without levels.
std::vector<package::PhotoRecord> records_of_image_set(std::span<const package::PhotoRecord> photos,
                                                       std::uint32_t image_set);

/// The samples, none for photos of other image sets.
std::vector<std::span<const package::SampleRecord>> samples_of_image_set(
    Samples samples, std::span<const package::PhotoRecord> photos, std::uint32_t image_set);

}  // namespace vantage
