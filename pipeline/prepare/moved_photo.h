#pragma once
#include <cstdint>

#include "pipeline/prepare/geometry_stages.h"
#include "scene/package_reader.h"

namespace vantage {

/// Gives a photo another pose (relative to the origin) and rewrites what depends on it, from the pixels that
/// the package holds of the photo. Thread-safe for different photos. Throws Error(damaged), Error(storage).
void move_photo(const GeometryContext& context, const PackageReader& part, std::uint32_t photo,
                const Pose& pose, package::PhotoRecord& record, package::PhotoState& state);

}  // namespace vantage
