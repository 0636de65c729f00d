#pragma once
#include <vector>

#include "player/measure/evaluation/luminance.h"
#include "player/measure/evaluation/place.h"

namespace vantage {

/// In pixels, to the right and down.
struct PixelShift {
    int x = 0, y = 0;
};

inline constexpr int max_shift = 6;  ///< px in each direction

/// For each cell with its margin, the shift of up to `max_shift` px for which picture(x + shift) is closest
/// to photo(x): least squared difference over the pixels whose `mask` is 1 (otherwise 0), the smaller shift
/// of equal ones. Outside the frame the picture continues with its edge. All planes have the same size.
std::vector<PixelShift> local_shifts(const Plane& photo, const Plane& picture, const Plane& mask);

}  // namespace vantage
