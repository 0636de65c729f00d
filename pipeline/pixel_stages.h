#pragma once
#include <future>

#include "pipeline/geometry_stages.h"
#include "pipeline/photo_file.h"
#include "pipeline/photo_run.h"

namespace vantage {

/// Decodes a photo, undistorts it where called for, and writes thumbnail and tiles as far as they are due.
/// `coarse` is given a value as soon as it is known. Throws Error(input) where the photo is no picture, or
/// not this camera's.
void make_pixels(const PhotoRun& run, const Due& due, PhotoFile& file, package::PhotoRecord& record,
                 std::promise<CoarsePixels>& coarse);

}  // namespace vantage
