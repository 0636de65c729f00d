#pragma once
#include <cstdint>
#include <future>
#include <vector>

#include "pipeline/photo_file.h"
#include "pipeline/photo_run.h"

namespace vantage {

/// Decodes a photo, undistorts it where called for, and writes thumbnail and tiles as far as they are due.
/// `valid` becomes the photo's validity at `mask_level`, a byte a texel, empty where it is opaque, as soon as
/// that is known. Throws Error(input) where the photo is no picture, or not this camera's.
void make_pixels(const PhotoRun& run, const Due& due, PhotoFile& file, package::PhotoRecord& record,
                 std::promise<std::vector<std::uint8_t>>& valid);

}  // namespace vantage
