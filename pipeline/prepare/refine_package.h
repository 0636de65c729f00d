#pragma once
#include <filesystem>
#include <map>

#include "pipeline/run/until_stopped.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// Recomputes the results of a package that depend on all photos (pose refinement, colors, transient
/// masking), applying `choices` to their effects. `out` becomes the package that `prepare` would write with
/// these choices. `out` may be `file`, which is replaced when the new package is complete. Throws
/// Error(damaged) if the package is damaged.
void refine_package(const std::filesystem::path& file, const std::map<Effect, EffectChoice>& choices,
                    const std::filesystem::path& out, const OnProgress& progress = {});

}  // namespace vantage
