#pragma once
#include <cstddef>

#include "scene/package/package_reader.h"

namespace vantage {

/// The exit code of pictures of a package that lack damaged tiles, as many as given; says so on stderr.
int exit_for_damaged_tiles(const PackageReader& package, std::size_t damaged);

}  // namespace vantage
