#pragma once
#include <filesystem>

#include "pipeline/run/until_stopped.h"

namespace vantage {

/// Writes a package again with its tiles in another form: compact, or raw. It shows the same scene, within
/// what compact forms round; a photo's own JPEG in it is kept, but not made, because the photos are not read.
/// Throws Error(damaged) if a part of the package is damaged.
void repack(const std::filesystem::path& file, bool compact, const std::filesystem::path& out,
            const OnProgress& progress = {});

}  // namespace vantage
