#pragma once
#include <span>

#include "pipeline/agree/shared_discs.h"
#include "pipeline/prepare/finish.h"
#include "scene/package_reader.h"

namespace vantage {

/// Finds content of single photos that the others contradict. If the scene calls for it (the worst photo is
/// contradicted on half a percent of the surface it shows), writes the weights into the masks' fourth
/// channel; masks that hold weights of an earlier run and need none are reset. `compared`: the records with
/// the gains and falloff that make the photos' colors agree, whether or not those effects are on. Throws
/// Error(damaged), Error(storage).
Consensus find_consensus(const FinishInput& input, const PackageReader& part, const PhotoSamples& samples,
                         std::span<const package::PhotoRecord> compared, PhotoTables& photos);

}  // namespace vantage
