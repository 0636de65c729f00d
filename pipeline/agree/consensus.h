#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/agree/color_agreement.h"
#include "pipeline/agree/folds.h"
#include "pipeline/run/lru_cache.h"
#include "scene/camera.h"
#include "scene/package_reader.h"
#include "values/grid.h"

namespace vantage {

/// Color and depth of a photo at a coarse level.
struct ConsensusView {
    int width = 0, height = 0;
    Intrinsics k;  ///< of this level
    Pose pose;     ///< relative to the origin
    struct Texel {
        float ln[3];            ///< of linear light; NaN if the photo has no pixel
        float low[3], high[3];  ///< range of `ln` over the 3x3 texels around this one
        float z;                ///< +inf if the photo does not see the model
    };
    std::vector<Texel> texels;  ///< row by row

    Grid<const Texel> grid() const { return {texels.data(), width, height}; }
};
/// Colors as exposed.
ConsensusView consensus_view(const CoarsePhoto& photo);

/// The view in the exposure of the mean photo, without the lens's falloff.
ConsensusView corrected(ConsensusView view, const std::array<double, 3>& ln_gain, const Falloff& falloff);

/// Where other photos contradict a photo.
struct ConsensusMap {
    int width = 0, height = 0;
    std::vector<std::uint8_t> weight;  ///< 255: not contradicted; 0: others agree on another color
    double disagreeing = 0;            ///< share of the compared texels with weight below 128
};

/// Compares each texel with the same place in `others`. The weight falls when no other photo shows its color
/// around that place within 0.35 (ln of linear light), and it is outside the range that most of them show by
/// more than 0.35 plus twice the spread among them; it is 0 at twice that. Single texels are ignored as
/// noise. The weight is 255 if fewer than two others see the place or they disagree among themselves. At most
/// six others are used per texel.
ConsensusMap consensus_of(const ConsensusView& photo, std::span<const ConsensusView* const> others);

/// The photos that each photo is compared with: the six that share the most surface with it from similar
/// directions, and those that chose it.
class ConsensusPartners {
  public:
    explicit ConsensusPartners(const SharedSurface& shared);
    /// Ascending. `without`: as if that photo were not in the scene.
    std::vector<std::uint32_t> of(std::uint32_t photo, std::optional<std::uint32_t> without = {}) const;

  private:
    bool chooses(std::uint32_t photo, std::uint32_t other, std::optional<std::uint32_t> without) const;
    std::vector<std::vector<std::uint32_t>> best_;       ///< per photo: one more than it chooses
    std::vector<std::vector<std::uint32_t>> chosen_by_;  ///< per photo: those that list it in `best_`
};

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
