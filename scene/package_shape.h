#pragma once
#include <string>
#include <vector>

#include "scene/package_reader.h"

namespace vantage {

/// What in a package does not have the length, the count or the range that its records promise, a line each:
/// chunks and tiles that are missing or of another size, triangles of vertices that are not there, clusters
/// that do not cover the triangles one after the other or whose spheres are no spheres. None: memory can be
/// indexed by what the records say.
/// Reads SCEN, PHOT, INDX and CLUS; of the rest the directory alone. Throws Error(damaged) where those four
/// cannot be read.
std::vector<std::string> misshapen(const PackageReader& package);
/// Throws Error(damaged) with the first of them.
void expect_shape(const PackageReader& package);

}  // namespace vantage
