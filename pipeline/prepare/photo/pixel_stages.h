#pragma once
#include <future>

#include "pipeline/input/photo_file.h"
#include "pipeline/prepare/photo/photo_job.h"

namespace vantage {

/// Decodes the photo and runs the stages in `missing` that do not use the model. The promise `coarse` is
/// fulfilled as soon as the levels that it contains exist. Throws Error(input) if the photo cannot be decoded
/// or does not fit its camera.
void make_pixels(const PhotoJob& job, const StageSet& missing, PhotoFile& file, package::PhotoRecord& record,
                 std::promise<CoarsePixels>& coarse);

}  // namespace vantage
