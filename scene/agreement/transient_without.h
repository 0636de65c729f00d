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

/// The transient masks that a package's photos would have if one of them did not exist, computed on demand
/// from the package.
class TransientWithout {
  public:
    /// `samples`: the samples read from the package. Throws Error(damaged).
    TransientWithout(const PackageReader& package, const PhotoSamples& samples);

    /// Chooses the photo to hold out. `colors`: gains and vignetting fitted without this photo. `photos`: the
    /// package's records with the poses refined without this photo.
    void hold_out(std::uint32_t photo, PhotoColors colors, std::span<const package::PhotoRecord> photos);
    /// The transient mask of another photo, as `prepare --hold-out` writes it to the weight maps; null if it
    /// has fewer than two partners. Valid until the next call of hold_out(). Throws Error(damaged).
    const TransientMap* of(std::uint32_t photo);

  private:
    TransientPartners partners_;
    LruCache<TransientView> uncorrected_;
    std::uint32_t without_ = 0;
    PhotoColors colors_;
    std::vector<Pose> poses_;
    std::optional<LruCache<TransientView>>
        corrected_;  ///< views with the color corrections that were fitted without the held-out photo
    std::map<std::uint32_t, TransientMap> maps_;
};

}  // namespace vantage
