#pragma once
#include <cstdint>
#include <span>

#include "scene/package/package_reader.h"

namespace vantage {

/// Replaces the poses in the package's photo records by those found without what `photo` shows: that of the
/// photo itself by the one given. Throws Error(damaged).
void use_poses_without(const PackageReader& package, std::uint32_t photo,
                       std::span<package::PhotoRecord> records);

}  // namespace vantage
