#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/photo_run.h"
#include "pipeline/stages/clusters.h"
#include "pipeline/stages/photo_geometry.h"
#include "pipeline/stages/photo_projection.h"

namespace vantage {

/// What a photo's camera looks at.
struct PhotoView {
    FrameTriangles triangles;
    Eigen::Vector2d near_far;
    PhotoProjection projection;
};
PhotoView view_of(const PhotoRun& run);

/// Writes texture coordinates, masks and coverage, as far as they are due, from what the photo's camera sees
/// of the model; notes the findings in the record. `valid` as make_pixels returns it.
void make_from_geometry(const PhotoRun& run, const Due& due, const PhotoView& view, PhotoGeometry geometry,
                        std::vector<std::uint8_t> valid, package::PhotoRecord& record);

}  // namespace vantage
