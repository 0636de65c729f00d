#pragma once
#include <filesystem>
#include <map>

#include "pipeline/run/progress.h"
#include "scene/effects.h"

namespace vantage {

/// Settles anew how a package's photos agree, with these choices for their effects: `out` holds
/// what `prepare` would give with them. It may be `file` itself, which stays until the new one is whole.
/// Throws Error(damaged) for a package that is not sound.
void refine_package(const std::filesystem::path& file, const std::map<Effect, EffectChoice>& choices,
                    const std::filesystem::path& out, const OnProgress& progress = {});

}  // namespace vantage
