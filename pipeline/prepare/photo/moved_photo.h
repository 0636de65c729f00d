#pragma once
#include <cstdint>

#include "pipeline/stages/stage_input.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Changes a photo's pose (relative to the origin) and rewrites the chunks that depend on the pose, using the
/// photo's pixels in the package. Thread-safe for different photos. Throws Error(damaged) or Error(storage).
void move_photo(const GeometryContext& context, const PackageReader& part, std::uint32_t photo,
                const Pose& pose, package::PhotoRecord& record, package::PhotoState& state);

}  // namespace vantage
