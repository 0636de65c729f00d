#pragma once
#include <vector>

#include "player/render/picture.h"

namespace vantage {

/// The brightness of a photo relative to a picture of its view, in stops of linear light: the median over
/// cells, and the quartiles. All 0 if no cell can be compared.
struct RelativeBrightness {
    double stops = 0, lower = 0, upper = 0;

    /// Whether the whole photo differs in brightness, as with a different exposure, and not only an occluded
    /// or shadowed part of it: both quartiles are near the median.
    bool throughout() const;
};

/// Uses the cells of which at least half is `scored` (one flag per pixel). Cell means are insensitive to
/// slight displacement.
RelativeBrightness relative_brightness(const Picture& photo, const Picture& picture,
                                       const std::vector<bool>& scored);

}  // namespace vantage
