#pragma once
#include <vector>

#include "scene/package/contents/scalar_field.h"

namespace vantage {

/// The stored fields, and two fields that are computed on demand from the visibility in the photos: the
/// number of photos ("photo-count") and the sampling density ("photo-density"). A stored field with one of
/// these names takes precedence. Without photos or vertices, there are no computed fields. Throws
/// Error(damaged), see read_fields.
std::vector<ScalarField> all_fields(const PackageReader& package);

/// One value per vertex of the mesh. A photo sees a vertex if it sees the whole of a triangle that uses the
/// vertex (VISB). `count` is the number of photos that see the vertex. `density` is the number of pixels per
/// input unit, perpendicular to the ray, in the photo with the highest density; NaN if no photo sees the
/// vertex.
std::vector<float> measure_photos(const PackageReader& package, PhotoMeasure measure);

}  // namespace vantage
