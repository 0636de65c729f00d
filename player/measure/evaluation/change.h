#pragma once
#include <optional>

#include "player/measure/evaluation/picture_metrics.h"
#include "player/measure/evaluation/place.h"

namespace vantage {

/// The change between two pictures of one photo's view, over the pixels that both show.
struct Change {
    PictureScore before, after;
    /// The regions in which the squared difference from the photo, after gains, has decreased and increased
    /// the most; empty if the change is below a root mean square of three gray levels.
    std::optional<Place> better, worse;
};

/// All pictures have the same size; `scored`: one flag per pixel.
Change change_of(const Picture& photo, const Picture& before, const Picture& after,
                 const std::vector<bool>& scored);

}  // namespace vantage
