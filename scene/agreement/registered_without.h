#pragma once
#include <cstdint>
#include <span>

#include "scene/package/package_reader.h"

namespace vantage {

/// Replaces the poses in the package's photo records with the poses refined without `photo`, and the pose of
/// `photo` itself with its input pose. Throws Error(damaged).
void use_poses_without(const PackageReader& package, std::uint32_t photo,
                       std::span<package::PhotoRecord> records);

}  // namespace vantage
