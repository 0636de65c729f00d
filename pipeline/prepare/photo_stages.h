#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/prepare/photo_job.h"

namespace vantage {

/// Takes photo `i` through all stages into the package and completes its record and state. What earlier runs
/// made from the same inputs is reused, the rest is made; on a spare core, the stages that look at the model
/// run while the photo is decoded and cut into tiles. A photo that cannot be decoded is left out; its state
/// says why. Returns the stages that ran. Thread-safe for different photos. Throws Error.
std::vector<package::Stage> run_photo(const PhotoContext& context, std::uint32_t i, bool spare_core,
                                      package::PhotoRecord& record, package::PhotoState& state);

}  // namespace vantage
