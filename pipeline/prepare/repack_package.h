#pragma once
#include <filesystem>

#include "pipeline/run/until_stopped.h"

namespace vantage {

/// Writes the package again with compact or raw tiles. The scene stays the same, to within the rounding of
/// compact tiles. A photo's own JPEG is kept if the package has it, but cannot be added, because the photos
/// are not read. Throws Error(damaged) if any part of the package is damaged.
void repack(const std::filesystem::path& file, bool compact, const std::filesystem::path& out,
            const OnProgress& progress = {});

}  // namespace vantage
