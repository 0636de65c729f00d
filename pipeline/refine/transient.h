#pragma once
#include <span>
#include <vector>

#include "base/values/lru_cache.h"
#include "pipeline/refine/color_agreement.h"
#include "pipeline/refine/folds.h"
#include "scene/agreement/transient_map.h"
#include "scene/agreement/transient_partners.h"

namespace vantage {

/// Colors as exposed.
TransientView transient_view(const CoarsePhoto& photo);

/// Photos as exposed, made on demand.
using TransientViews = LruCache<TransientView>;
inline constexpr std::size_t cached_views = 16;  ///< that are held at once, as exposed and as corrected

/// The maps of all photos, each compared with its partners. Keeps a bounded number of photos in memory. Empty
/// for photos with fewer than two partners. `uncorrected` may throw Error(damaged).
std::vector<TransientMap> transient_maps(const TransientViews& uncorrected, const PhotoColors& colors,
                                         const TransientPartners& partners, unsigned threads);

/// What transient masks are worth to held-out photos, which vote neither on weight maps nor on gains.
/// `uncorrected`: at the folds' levels. `fits`: per fold, the colors fitted without its photo. `gains_on`,
/// `vignetting_on`: whether to blend with them.
Judgment validate_transients(const Folds& folds, const TransientViews& uncorrected,
                             const TransientPartners& partners, std::span<const PhotoColors> fits,
                             bool gains_on, bool vignetting_on);

}  // namespace vantage
