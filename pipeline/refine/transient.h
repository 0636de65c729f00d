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

/// Photos as exposed, created on demand.
using TransientViews = LruCache<TransientView>;
inline constexpr std::size_t cached_views = 16;  ///< cached at once, as exposed and as corrected

/// The maps of all photos, each compared with its partners. Keeps a bounded number of photos in memory. Empty
/// for photos with fewer than two partners. `uncorrected` may throw Error(damaged).
std::vector<TransientMap> transient_maps(const TransientViews& uncorrected, const PhotoColors& colors,
                                         const TransientPartners& partners, unsigned threads);

/// Validates transient masks on held-out photos, which influence neither weight maps nor gains.
/// `uncorrected`: at the folds' levels. `fits`: per fold, the colors fitted without the fold's photo.
/// `gains_on`, `vignetting_on`: whether to blend with them.
Judgment validate_transients(const Folds& folds, const TransientViews& uncorrected,
                             const TransientPartners& partners, std::span<const PhotoColors> fits,
                             bool gains_on, bool vignetting_on);

}  // namespace vantage
