#pragma once
#include <cstdint>
#include <future>
#include <vector>

#include "pipeline/photo_file.h"
#include "pipeline/photo_run.h"
#include "pipeline/rgba_image.h"

namespace vantage {

/// What the stages that come from the model read of a photo.
struct CoarsePixels {
    std::vector<std::uint8_t> valid;  ///< at `mask_level`, a byte a texel; empty where the photo is opaque
    RgbaImage samples;                ///< the photo at `sample_level`
};

/// Decodes a photo, undistorts it where called for, and writes thumbnail and tiles as far as they are due.
/// `coarse` is given a value as soon as it is known. Throws Error(input) where the photo is no picture, or
/// not this camera's.
void make_pixels(const PhotoRun& run, const Due& due, PhotoFile& file, package::PhotoRecord& record,
                 std::promise<CoarsePixels>& coarse);

}  // namespace vantage
