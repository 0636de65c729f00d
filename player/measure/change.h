#pragma once
#include <optional>

#include "player/measure/picture_metrics.h"

namespace vantage {

/// A part of a picture, in its pixels.
struct Place {
    int x, y, width, height;
};

/// What has changed between two pictures made of one photo's view, over the pixels that both show.
struct Change {
    PictureScore before, after;
    /// Where squared differences from the photo, gains applied, fell and rose most; none where nowhere by
    /// more than three grey levels would make.
    std::optional<Place> better, worse;
};

/// All of one size; `scored`: flags of the pixels to compare.
Change change_of(const Picture& photo, const Picture& before, const Picture& after,
                 const std::vector<bool>& scored);

/// A place in the photo and in both pictures, side by side, left to right.
Picture side_by_side(const Picture& photo, const Picture& before, const Picture& after, const Place& place);

}  // namespace vantage
