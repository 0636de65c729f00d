#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/values/lru_cache.h"
#include "scene/agreement/transient_view.h"

namespace vantage {

/// The areas of a photo that other photos contradict.
struct TransientMap {
    int width = 0, height = 0;
    std::vector<std::uint8_t> weight;  ///< 255: not contradicted; 0: other photos agree on a different color
    double disagreeing = 0;            ///< fraction of the compared texels with weight below 128
};

/// Compares each texel with the same place in the `others`. The weight falls if no other photo shows the
/// color around that place to within 0.35 (in ln of linear light) and the color's median distance from the
/// color ranges of the other photos exceeds 0.35 plus twice the spread of their colors. At twice that
/// distance, the weight is 0. Single texels are ignored as noise. The weight is 255 if fewer than two other
/// photos see the place, or if these disagree among themselves. At most six other photos are used per texel.
TransientMap transient_of(const TransientView& photo, std::span<const TransientView* const> others);

/// Compares one of many photos with the views of its `partners` in the same way. Empty if the photo has fewer
/// than two partners.
TransientMap transient_of(std::uint32_t photo, std::span<const std::uint32_t> partners,
                          const LruCache<TransientView>& views);

/// Removes single texels below 255 as noise, and expands the remaining areas over their blurred edges: a 3x3
/// median, a minimum over 5x5 texels without three at each corner, and a 3x3 binomial blur.
std::vector<std::uint8_t> without_noise(const std::vector<std::uint8_t>& weight, int width, int height);

}  // namespace vantage
