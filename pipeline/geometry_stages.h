#pragma once
#include <cstdint>
#include <future>
#include <vector>

#include "pipeline/photo_run.h"
#include "pipeline/pixel_stages.h"
#include "pipeline/stages/photo_geometry.h"

namespace vantage {

PhotoView view_of(const PhotoRun& run);

/// Writes texture coordinates, masks, coverage and colour samples, as far as they are due, from what the
/// photo's camera sees of the model and from `pixels`, which make_pixels finds; notes the findings in the
/// record.
void make_from_geometry(const PhotoRun& run, const Due& due, const PhotoView& view, PhotoGeometry geometry,
                        std::future<CoarsePixels> pixels, package::PhotoRecord& record);

}  // namespace vantage
