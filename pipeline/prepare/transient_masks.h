#pragma once
#include <span>

#include "pipeline/prepare/finish.h"
#include "pipeline/refine/folds.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Finds content of single photos that other photos contradict. If the effect is on, writes the weights to
/// the weight maps' fourth channel; weights of an earlier run that are no longer needed are reset. The effect
/// is considered if the worst photo is contradicted on more than half a percent of its visible surface, and
/// then validated with held-out photos. Throws Error(damaged), Error(storage).
TransientMasks find_transients(const FinishInput& input, const PackageReader& part, const Folds& folds,
                               const ColorRefinement& colors, PhotoTables& photos);

}  // namespace vantage
