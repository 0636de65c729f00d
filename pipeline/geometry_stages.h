#pragma once
#include <cstdint>
#include <future>
#include <vector>

#include "pipeline/photo_run.h"
#include "pipeline/stages/photo_geometry.h"

namespace vantage {

PhotoView view_of(const PhotoRun& run);

/// Writes texture coordinates, masks and coverage, as far as they are due, from what the photo's camera sees
/// of the model; notes the findings in the record. `valid` as make_pixels finds it.
void make_from_geometry(const PhotoRun& run, const Due& due, const PhotoView& view, PhotoGeometry geometry,
                        std::future<std::vector<std::uint8_t>> valid, package::PhotoRecord& record);

}  // namespace vantage
