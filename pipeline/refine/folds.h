#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/values/lru_cache.h"
#include "pipeline/refine/coarse_photo.h"
#include "pipeline/refine/poses/sightings.h"
#include "scene/agreement/photo_pairs.h"

namespace vantage {

/// How much Folds holds in memory: coarse photos, and sightings of folds (some 2 MB each).
inline constexpr std::size_t cached_photos = 64, kept_sightings = 12;
inline constexpr std::size_t max_others = 8;  ///< that a photo is predicted from

/// Where Folds reads photos from. The spans must outlive it.
struct FoldsInput {
    const PackageReader& package;                  ///< with tiles, weight maps and depth
    std::span<const package::PhotoRecord> photos;  ///< with their poses
    Samples samples;
    std::span<const SurfaceDisc> discs;  ///< one per sample of a photo
    double border_width = 0;             ///< as in SceneRecord
    unsigned threads = 0;
    int long_side = 256;         ///< of the levels at which photos are read, texels
    std::size_t max_folds = 24;  ///< photos held out at most
};

/// A photo that is held out, and those that it is predicted from.
struct Fold {
    std::uint32_t photo;
    std::vector<std::uint32_t> others;  ///< up to max_others that share the most surface, ascending
};

/// Cross-validation: photos that are held out of everything in turn, spread over the scene.
/// Photos are read at the finest level with at most 256 texels on the longer side.
class Folds {
  public:
    explicit Folds(const FoldsInput& input);

    const FoldsInput& input() const { return in_; }
    const SharedSurface& shared() const { return shared_; }
    const std::vector<Fold>& all() const { return folds_; }
    /// At which a photo is read.
    int level(std::uint32_t photo) const;
    std::shared_ptr<const CoarsePhoto> photo(std::uint32_t photo) const { return photos_.get(photo); }

    /// A fold's photo, and what the others show.
    struct View {
        const Fold& fold;
        std::size_t index;          ///< of the fold
        const CoarsePhoto& target;  ///< every second texel of the fold's photo: enough to judge
        const Folds& folds;

        /// What the others show at the photo's pixels. Kept for the next call, of some folds.
        std::shared_ptr<const Sightings> sightings() const;
        /// With other poses, one per photo of the scene; `own`: that of the fold's photo.
        Sightings sightings(std::span<const Pose> poses, const Pose& own) const;
    };
    /// Reads the photos of all folds, as far as they are kept, so that they need not be waited for later.
    void read_ahead() const;
    /// Calls visit(view) for every fold, on several threads. Throws Error(damaged).
    void each(const std::function<void(const View&)>& visit) const;

  private:
    Sightings sightings_of(const Fold& fold, const CoarsePhoto& target, std::span<const Pose> poses,
                           const Pose& own) const;

    FoldsInput in_;
    SharedSurface shared_;
    std::vector<Fold> folds_;
    LruCache<CoarsePhoto> photos_;
    mutable std::vector<std::shared_ptr<const Sightings>> kept_;  ///< of the first folds
};

}  // namespace vantage
