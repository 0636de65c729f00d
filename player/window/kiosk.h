#pragma once
#include <optional>

#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"
#include "player/tour/attract_loop.h"

namespace vantage {

/// A window for the public: it shows only the selected content, and returns to its initial state when idle.
struct Kiosk {
    RenderSettings settings;  ///< initial settings
    Panels panels;
    std::string language;
    std::optional<AttractLoop> tour;  ///< flown in a loop while idle
    double home_after = 60;           ///< seconds
    double touched_at = 0;            ///< seconds
    bool idle = true;                 ///< has returned to the initial state since `touched_at`
    bool tours = false;               ///< the flight in progress is the tour, or leads to its start
};

/// Makes a kiosk that returns to the session's current settings. Disables functions that are not for the
/// public.
Kiosk make_kiosk(Session& session, std::optional<AttractLoop> tour, double home_after);

/// Ends a tour on input; when idle, returns to the initial state, closes the open note and starts the tour.
/// A tour that a visitor plays is not idle. Returns whether the initial state has just been restored.
bool attend(Kiosk& kiosk, Session& session, ActiveStory& active, bool touched, double now);

/// The time, in seconds, at which attend() must be called next if there is no input.
double attends_at(const Kiosk& kiosk);

}  // namespace vantage
