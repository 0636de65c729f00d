#pragma once
#include <span>

#include "colors/shared_discs.h"
#include "pipeline/prepare/finish.h"
#include "scene/package_reader.h"

namespace vantage {

/// Finds content of single photos that other photos contradict. If the effect is on (automatically if the
/// worst photo is contradicted on more than half a percent of its visible surface), writes the weights to the
/// masks' fourth channel; weights left by an earlier run and no longer needed are reset. `compared`: the
/// records with the gains and falloff that make the photos' colors agree, whether or not those effects are
/// on. Throws Error(damaged), Error(storage).
Consensus find_consensus(const FinishInput& input, const PackageReader& part, const PhotoSamples& samples,
                         std::span<const package::PhotoRecord> compared, PhotoTables& photos);

}  // namespace vantage
