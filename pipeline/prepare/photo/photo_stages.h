#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/prepare/photo/photo_job.h"

namespace vantage {

/// Runs photo `i` through all stages, writes its chunks and completes its record and state. Chunks that
/// earlier runs made from the same inputs are reused. On a spare core, the stages that use the model run
/// while the photo is decoded and cut into tiles. A photo that cannot be decoded is skipped; its state gives
/// the reason. Returns the stages that ran. Thread-safe for different photos. Throws Error.
std::vector<package::Stage> run_photo(const PhotoContext& context, std::uint32_t i, bool spare_core,
                                      package::PhotoRecord& record, package::PhotoState& state);

}  // namespace vantage
