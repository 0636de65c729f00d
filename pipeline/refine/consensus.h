#pragma once
#include <span>
#include <vector>

#include "base/values/lru_cache.h"
#include "pipeline/refine/color_agreement.h"
#include "pipeline/refine/folds.h"
#include "scene/agreement/consensus_map.h"
#include "scene/agreement/consensus_partners.h"

namespace vantage {

/// Colors as exposed.
ConsensusView consensus_view(const CoarsePhoto& photo);

/// Photos as exposed, made on demand.
using ConsensusViews = LruCache<ConsensusView>;
inline constexpr std::size_t cached_views = 16;  ///< that are held at once, as exposed and as corrected

/// The maps of all photos, each compared with its partners. Keeps a bounded number of photos in memory. Empty
/// for photos with fewer than two partners. `uncorrected` may throw Error(damaged).
std::vector<ConsensusMap> consensus_maps(const ConsensusViews& uncorrected, const PhotoColors& colors,
                                         const ConsensusPartners& partners, unsigned threads);

/// What consensus masks are worth to left-out photos, which vote neither on masks nor on gains.
/// `uncorrected`: at the folds' levels. `fits`: per fold, the colors fitted without its photo. `gains_on`,
/// `falloff_on`: whether to blend with them.
Judgment judge_consensus(const Folds& folds, const ConsensusViews& uncorrected,
                         const ConsensusPartners& partners, std::span<const PhotoColors> fits, bool gains_on,
                         bool falloff_on);

}  // namespace vantage
