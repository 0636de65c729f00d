#pragma once
#include <span>
#include <vector>

#include "base/values/lru_cache.h"
#include "pipeline/refine/color_agreement.h"
#include "pipeline/refine/folds.h"
#include "scene/agreement/transient_map.h"
#include "scene/agreement/transient_partners.h"

namespace vantage {

/// The view of a photo for transient masking, with its colors as exposed.
TransientView transient_view(const CoarsePhoto& photo);

/// Views of photos as exposed, created on demand.
using TransientViews = LruCache<TransientView>;
/// Maximum number of views cached at once as exposed, and of those cached as corrected.
inline constexpr std::size_t cached_views = 16;

/// The transient maps of all photos; each photo is compared with its partners. The map is empty for photos
/// with fewer than two partners. The number of photos in memory is bounded. `uncorrected` may throw
/// Error(damaged).
std::vector<TransientMap> transient_maps(const TransientViews& uncorrected, const PhotoColors& colors,
                                         const TransientPartners& partners, unsigned threads);

/// Validates transient masks on held-out photos, which influence neither weight maps nor gains.
/// `uncorrected` holds the photos at the folds' levels. `fits` holds, for each fold, the colors fitted
/// without the fold's photo. `gains_on` and `vignetting_on`: whether to blend with gains and with vignetting
/// correction.
Judgment validate_transients(const Folds& folds, const TransientViews& uncorrected,
                             const TransientPartners& partners, std::span<const PhotoColors> fits,
                             bool gains_on, bool vignetting_on);

}  // namespace vantage
