#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/agree/photo_pairs.h"
#include "pipeline/judge/coarse_photo.h"
#include "pipeline/judge/sightings.h"
#include "pipeline/run/lru_cache.h"

namespace vantage {

/// Where Folds reads photos from. The spans must outlive it.
struct FoldsInput {
    const PackageReader& package;                  ///< with tiles, masks and depth
    std::span<const package::PhotoRecord> photos;  ///< with their poses
    Samples samples;
    std::span<const SurfaceDisc> discs;  ///< one per sample of a photo
    double border_width = 0;             ///< as in SceneRecord
    unsigned threads = 0;
    int long_side = 256;         ///< of the levels at which photos are read, texels
    std::size_t max_folds = 24;  ///< photos left out at most
};

/// A photo that is left out, and those that it is predicted from.
struct Fold {
    std::uint32_t photo;
    std::vector<std::uint32_t> others;  ///< up to 16 that share the most surface, ascending
};

/// Cross-validation: photos that are left out of everything in turn, spread over the scene.
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
        const CoarsePhoto& target;
        const Folds& folds;

        /// What the others show at the photo's pixels.
        Sightings sightings() const;
        /// With other poses, one per photo of the scene; `own`: that of the fold's photo.
        Sightings sightings(std::span<const Pose> poses, const Pose& own) const;
    };
    /// Calls visit(index of the fold, view) for every fold, on several threads. Throws Error(damaged).
    void each(const std::function<void(std::size_t, const View&)>& visit) const;

  private:
    Sightings sightings_of(const Fold& fold, std::span<const Pose> poses, const Pose& own) const;

    FoldsInput in_;
    SharedSurface shared_;
    std::vector<Fold> folds_;
    mutable LruCache<CoarsePhoto> photos_;
};

}  // namespace vantage
