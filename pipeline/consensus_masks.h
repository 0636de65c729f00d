#pragma once
#include <span>
#include <vector>

#include "pipeline/finish_package.h"
#include "pipeline/refine/shared_discs.h"
#include "scene/package_reader.h"

namespace vantage {

/// Finds what single photos show and others agree is not there, and makes the masks' fourth channel say so
/// where the scene calls for it: the worst photo is contradicted on half a percent of the surface that it
/// shows. Masks that said so and need not any more are set back. `compared`:
/// the photos' records with what makes their colours agree, whether or not it is on. Throws Error(damaged),
/// Error(storage).
Consensus settle_consensus(const FinishInput& input, const PackageReader& part, const PhotoSamples& samples,
                           std::span<const package::PhotoRecord> compared, PhotoTables& photos);

}  // namespace vantage
