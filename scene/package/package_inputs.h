#pragma once
#include "scene/package/output_file.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Files that outputs made from a package must not overwrite: the package and, identified by content, the
/// inputs of its preparation. If META cannot be parsed, the inputs are not included. Throws Error(damaged).
Inputs inputs_of(const PackageReader& package);

}  // namespace vantage
