#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/prepare/finish.h"
#include "scene/package/package_writer.h"

namespace vantage {

// These functions join the results of the image sets into one result for all photos. If there is a single
// image set, its result is returned unchanged.

/// The effect is on if it is on for any image set. `names`: the names of the image sets, in the order of
/// `decisions`.
EffectDecision joined(std::span<const EffectDecision> decisions, std::span<const std::string> names);

/// Each photo takes its result from its own image set.
PoseRefinement joined(std::vector<PoseRefinement> image_sets, std::span<const package::PhotoRecord> photos,
                      std::span<const std::string> names);
ColorRefinement joined(std::vector<ColorRefinement> image_sets, std::span<const package::PhotoRecord> photos,
                       std::span<const std::string> names);
TransientMasks joined(std::vector<TransientMasks> image_sets, std::span<const package::PhotoRecord> photos,
                      std::span<const std::string> names);

/// The effects that are on for each image set: those from its own decisions and, for the first image set,
/// also the background.
std::vector<EffectSet> effects_of_image_sets(std::span<const EffectDecision> decisions,
                                             std::size_t image_sets);

/// Writes BAND if there are several image sets. `effects`: per image set; empty if not decided yet.
void write_image_sets(PackageWriter& writer, std::span<const std::string> names,
                      std::span<const EffectSet> effects);

}  // namespace vantage
