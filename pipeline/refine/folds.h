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

/// Cache sizes of Folds: the number of coarse photos, and of folds whose sightings are kept (about 2 MB
/// each).
inline constexpr std::size_t cached_photos = 64, kept_sightings = 12;
inline constexpr std::size_t max_others = 8;  ///< maximum number of photos from which a photo is predicted

/// The input of Folds. The objects referred to must outlive the Folds object.
struct FoldsInput {
    const PackageReader& package;                  ///< package with tiles, weight maps and depth
    std::span<const package::PhotoRecord> photos;  ///< with their poses
    Samples samples;
    std::span<const SurfaceDisc> discs;  ///< one per sample of a photo
    unsigned threads = 0;
    int long_side = 256;         ///< maximum longer side, in texels, of the levels at which photos are read
    std::size_t max_folds = 24;  ///< maximum number of photos held out
};

/// A held-out photo and the photos from which it is predicted.
struct Fold {
    std::uint32_t photo;
    std::vector<std::uint32_t> others;  ///< up to max_others with the most surface in common, ascending
};

/// Cross-validation: photos spread over the scene are held out of all estimates one at a time. Photos are
/// read at the finest level with at most 256 texels on the longer side.
class Folds {
  public:
    explicit Folds(const FoldsInput& input);

    const FoldsInput& input() const { return in_; }
    const SharedSurface& shared() const { return shared_; }
    const std::vector<Fold>& all() const { return folds_; }
    /// The level at which a photo is read.
    int level(std::uint32_t photo) const;
    std::shared_ptr<const CoarsePhoto> photo(std::uint32_t photo) const { return photos_.get(photo); }

    /// A fold's photo, and where the other photos see its surface.
    struct View {
        const Fold& fold;
        std::size_t index;          ///< of the fold
        const CoarsePhoto& target;  ///< every second texel of the fold's photo, which suffices
        const Folds& folds;

        /// How the other photos see the surface at the photo's pixels. The result is cached for some folds.
        std::shared_ptr<const Sightings> sightings() const;
        /// Computes these sightings with other poses, one per photo of the scene; `own` is the pose of the
        /// fold's photo.
        Sightings sightings(std::span<const Pose> poses, const Pose& own) const;
    };
    /// Reads as many of the folds' photos into the cache as fit, so that later calls need not wait.
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
    mutable std::vector<std::shared_ptr<const Sightings>> kept_;  ///< sightings of the first folds
};

}  // namespace vantage
