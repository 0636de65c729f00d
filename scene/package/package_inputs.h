#pragma once
#include "scene/package/output_file.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Files that outputs made from a package must not overwrite: the package and, identified by content, the
/// inputs of its preparation. Inputs are missing if META cannot be parsed. Throws Error(damaged).
Inputs inputs_of(const PackageReader& package);

}  // namespace vantage
