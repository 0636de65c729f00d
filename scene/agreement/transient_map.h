#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/values/lru_cache.h"
#include "scene/agreement/transient_view.h"

namespace vantage {

/// Where other photos contradict a photo.
struct TransientMap {
    int width = 0, height = 0;
    std::vector<std::uint8_t> weight;  ///< 255: not contradicted; 0: others agree on another color
    double disagreeing = 0;            ///< share of the compared texels with weight below 128
};

/// Compares each texel with the same place in `others`. The weight falls when no other photo shows its color
/// around that place within 0.35 (ln of linear light), and it is outside the range that most of them show by
/// more than 0.35 plus twice the spread among them; it is 0 at twice that. Single texels are ignored as
/// noise. The weight is 255 if fewer than two others see the place or they disagree among themselves. At most
/// six others are used per texel.
TransientMap transient_of(const TransientView& photo, std::span<const TransientView* const> others);

/// The same for one of many photos, with the views of `partners` as others. Empty if there are fewer than
/// two.
TransientMap transient_of(std::uint32_t photo, std::span<const std::uint32_t> partners,
                          const LruCache<TransientView>& views);

/// Removes single texels below 255, which are noise, and grows the rest over its blurred edges: median of
/// 3x3, minimum over 5x5 without the corners' three texels, binomial blur of 3x3.
std::vector<std::uint8_t> without_noise(const std::vector<std::uint8_t>& weight, int width, int height);

}  // namespace vantage
