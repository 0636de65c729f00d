#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/agreement/shared_discs.h"
#include "scene/package/package_format.h"

namespace vantage {

// Joint estimates are made for each image set separately, as if the photos of other image sets had no pixels.

/// The highest image set number of any photo, plus one.
std::uint32_t image_set_count(std::span<const package::PhotoRecord> photos);

/// The photo records, in which photos of other image sets have no levels.
std::vector<package::PhotoRecord> records_of_image_set(std::span<const package::PhotoRecord> photos,
                                                       std::uint32_t image_set);

/// The samples of the photos; photos of other image sets have none.
std::vector<std::span<const package::SampleRecord>> samples_of_image_set(
    Samples samples, std::span<const package::PhotoRecord> photos, std::uint32_t image_set);

}  // namespace vantage
