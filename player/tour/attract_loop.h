#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "player/tour/story_views.h"
#include "player/view/turntable.h"

namespace vantage {

/// A flight that an idle kiosk or auto-rotation repeats, either along a curve or through positions that are
/// evenly spaced in time.
struct AttractLoop {
    std::vector<Navigation> positions{};
    std::shared_ptr<const CameraSpline> along{};
    double seconds = 0;
    StoryTour tour{};  ///< the stops of `along`, which begins at the first of them; empty for other flights

    Navigation begin() const { return along ? along->at(0) : positions.front(); }
};

/// A full turn around the target of `start`, or a swing in an arc.
AttractLoop turn_around(const Navigation& start, double seconds, const Arc& arc = {});

/// The content that the story has for an idle kiosk whose first view is `home`; nullopt if it has none.
/// Throws Error(input) naming `story_file` if a stop has no view.
std::optional<AttractLoop> attract_loop(const Story& story, const Navigation& home, const InputAxes& axes,
                                        const std::string& story_file);

}  // namespace vantage
