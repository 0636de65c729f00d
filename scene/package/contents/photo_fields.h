#pragma once
#include <vector>

#include "scene/package/contents/scalar_field.h"

namespace vantage {

/// The package's fields, and those that follow from what its photos see, which no package stores: the number
/// of photos ("photo-count") and the sampling density ("photo-density"). Their values are measured when they
/// are needed. A stored field of the same name takes their place, and without photos or vertices there are
/// none. Throws Error(damaged), see read_fields.
std::vector<ScalarField> all_fields(const PackageReader& package);

/// One value per vertex of the mesh. A photo sees a vertex if it sees all of one of its triangles (VISB).
/// Count: the number of photos that see it. Density: pixels per input unit, at right angles to the ray, of
/// the photo that has most; NaN where no photo sees the vertex.
std::vector<float> measure_photos(const PackageReader& package, PhotoMeasure measure);

}  // namespace vantage
