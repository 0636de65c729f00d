#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "base/values/lru_cache.h"
#include "scene/agreement/transient_map.h"
#include "scene/agreement/transient_partners.h"

namespace vantage {

/// Transient masking maps of a package's photos as if one of them did not exist, made on demand from what the
/// package holds.
class TransientWithout {
  public:
    /// `samples` as read from the package. Throws Error(damaged).
    TransientWithout(const PackageReader& package, const PhotoSamples& samples);

    /// Chooses the photo that does not exist. `colors`: fitted without it; `photos`: the package's records,
    /// with poses found without it.
    void hold_out(std::uint32_t photo, PhotoColors colors, std::span<const package::PhotoRecord> photos);
    /// What `prepare --hold-out` writes to the weight maps of another photo; null if it has fewer than two
    /// partners. Valid until hold_out. Throws Error(damaged).
    const TransientMap* of(std::uint32_t photo);

  private:
    TransientPartners partners_;
    LruCache<TransientView> uncorrected_;
    std::uint32_t without_ = 0;
    PhotoColors colors_;
    std::vector<Pose> poses_;
    std::optional<LruCache<TransientView>> corrected_;  ///< for the photo held out
    std::map<std::uint32_t, TransientMap> maps_;
};

}  // namespace vantage
