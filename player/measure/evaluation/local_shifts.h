#pragma once
#include <vector>

#include "player/measure/evaluation/luminance.h"
#include "player/measure/evaluation/place.h"

namespace vantage {

/// A shift in pixels, to the right and down.
struct PixelShift {
    int x = 0, y = 0;
};

inline constexpr int max_shift = 6;  ///< maximum shift in each direction, px

/// For each cell with its margin, the shift of up to `max_shift` px that minimizes the squared difference
/// between picture(x + shift) and photo(x). Only uses pixels whose `mask` is 1; the other pixels have 0. If
/// minima are equal, takes the smallest shift. The picture is extended by its edge pixels. All planes have
/// the same size.
std::vector<PixelShift> local_shifts(const Plane& photo, const Plane& picture, const Plane& mask);

}  // namespace vantage
