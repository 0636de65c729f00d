#pragma once
#include "scene/package/output_file.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// What may not be overwritten by files made from a package: the package, and, by content, the inputs that it
/// was prepared from. Inputs are missing if META cannot be parsed. Throws Error(damaged).
Inputs inputs_of(const PackageReader& package);

}  // namespace vantage
