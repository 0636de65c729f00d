#pragma once
#include <string>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// Contradictions between a package's records and its contents, one line each: chunks and tiles that are
/// missing or have the wrong size, vertex indices that are out of range, and clusters that do not cover the
/// triangles in order or whose spheres are invalid. If there are no contradictions, it is safe to index into
/// the chunks with values from the records. Reads SCEN, PHOT, INDX and CLUS, and uses the directory for the
/// rest. Throws Error(damaged) if one of these four is unreadable.
std::vector<std::string> misshapen(const PackageReader& package);
/// Whether photos have texture coordinates per vertex; true if there are no photos.
bool has_coordinates(const PackageReader& package);
/// Throws Error(damaged) with the first contradiction.
void expect_shape(const PackageReader& package);

}  // namespace vantage
