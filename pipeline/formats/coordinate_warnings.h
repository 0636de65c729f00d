#pragma once
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Warnings of one line each about vertices far from all others (base/values/main_box.h) and about
/// coordinates that were rounded to few digits far from zero: to single precision or to a power of ten, in
/// steps of more than 1/100,000 of the mesh's size. There are no warnings about point clouds or about valid
/// meshes. Positions must be finite. The lines do not name the file. `rounding` is the largest error of a
/// coordinate, if known; an error above 1/100,000 of the size is then reported, and steps are not searched
/// for.
std::vector<std::string> coordinate_warnings(const Mesh& mesh, double rounding = 0);

}  // namespace vantage
