#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/prepare/finish.h"
#include "scene/package/package_writer.h"

namespace vantage {

// One result of all photos from those of each band; of a single band, its own.

/// On if it is on for any band. `names`: of the bands, in the order of `decisions`.
EffectDecision joined(std::span<const EffectDecision> decisions, std::span<const std::string> names);

/// Each photo's result is that of its own band.
Registration joined(std::vector<Registration> bands, std::span<const package::PhotoRecord> photos,
                    std::span<const std::string> names);
ColorRefinement joined(std::vector<ColorRefinement> bands, std::span<const package::PhotoRecord> photos,
                       std::span<const std::string> names);
Consensus joined(std::vector<Consensus> bands, std::span<const package::PhotoRecord> photos,
                 std::span<const std::string> names);

/// The effects that are on for each band, of what the bands decided and of surroundings, which are the first
/// band's.
std::vector<EffectSet> effects_of_bands(const Agreement& agreement, std::size_t bands);

/// Writes BAND if there are several bands. `effects`: per band; empty: none yet.
void write_bands(PackageWriter& writer, std::span<const std::string> names,
                 std::span<const EffectSet> effects);

}  // namespace vantage
