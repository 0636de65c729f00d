#pragma once
#include <filesystem>

#include "pipeline/run/until_stopped.h"

namespace vantage {

/// Writes a package with its tiles compact or raw. It shows the same scene, to within the rounding of compact
/// tiles. A photo's own JPEG is kept but cannot be added, because the photos are not read. Throws
/// Error(damaged) if a part of the package is damaged.
void repack(const std::filesystem::path& file, bool compact, const std::filesystem::path& out,
            const OnProgress& progress = {});

}  // namespace vantage
