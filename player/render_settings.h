#pragma once
#include <cstddef>
#include <limits>

#include "player/weights.h"

namespace vantage {

/// Weighted average [M], unstructured lumigraph (after Buehler et al. 2001) or best photo [P].
enum class Blend { average, lumigraph, best };
enum class Coordinates { automatic, vertex, fragment };  ///< automatic: as the package's effects say

inline constexpr int most_photos_per_pass = 16;

/// How a view is rendered.
struct RenderSettings {
    Blend blend = Blend::average;
    Coordinates coordinates = Coordinates::automatic;
    WeightSettings weights;
    bool fill_holes = false;  ///< plain shading where no photo contributes, background beside the model
    int samples = 1;          ///< along each side of a pixel, 1 to 8
    int photos_per_pass = 4;  ///< 1 to 16
    std::size_t uploads = std::numeric_limits<std::size_t>::max();  ///< tiles a frame may upload
    float background[3] = {0.012f, 0.014f, 0.018f};                 ///< linear
};

/// What a rendered frame was made of.
struct FrameReport {
    std::size_t clusters = 0, photos = 0, passes = 0;
    std::size_t tiles = 0;          ///< needed
    std::size_t tiles_missing = 0;  ///< of them not resident: coarser levels were shown
    std::size_t tiles_damaged = 0;  ///< seen since opening
};

}  // namespace vantage
