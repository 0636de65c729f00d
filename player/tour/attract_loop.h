#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "player/tour/story_views.h"

namespace vantage {

/// A flight that an idle kiosk repeats: along a curve, or through positions evenly spaced in time.
struct AttractLoop {
    std::vector<Navigation> positions{};
    std::shared_ptr<const CameraSpline> along{};
    double seconds = 0;

    Navigation begin() const { return along ? along->at(0) : positions.front(); }
};

/// The story's content for an idle kiosk whose first view is `home`; nullopt if it has none. Throws
/// Error(input) naming `story_file` for a stop without a view.
std::optional<AttractLoop> attract_loop(const Story& story, const Navigation& home, const InputAxes& axes,
                                        const std::string& story_file);

}  // namespace vantage
