#pragma once
#include <span>

#include "pipeline/prepare/finish.h"
#include "pipeline/refine/folds.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Finds content that appears in individual photos and is contradicted by others. If the effect is on, its
/// weights are written to the weight maps' fourth channel; weights from an earlier run that are no longer
/// needed are reset. The effect is considered if the worst photo is contradicted on more than half a percent
/// of its visible surface; it is then validated with held-out photos. Throws Error(damaged) or
/// Error(storage).
TransientMasks find_transients(const FinishInput& input, const PackageReader& part, const Folds& folds,
                               const ColorRefinement& colors, PhotoTables& photos);

}  // namespace vantage
