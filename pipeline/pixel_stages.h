#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/photo_file.h"
#include "pipeline/photo_run.h"

namespace vantage {

/// Decodes a photo, undistorts it where called for, and writes thumbnail and tiles as far as they are due.
/// Returns the photo's validity at `mask_level`, a byte a texel, empty where it is opaque. Throws
/// Error(input) where the photo is no picture, or not this camera's.
std::vector<std::uint8_t> make_pixels(const PhotoRun& run, const Due& due, PhotoFile& file,
                                      package::PhotoRecord& record);

}  // namespace vantage
