#pragma once
#include <optional>

#include "player/interface/state/session.h"
#include "player/tour/attract_loop.h"

namespace vantage {

/// A window that the public uses: it shows only what was chosen before, and returns to that when nobody has
/// touched it for a while.
struct Kiosk {
    RenderSettings settings;  ///< those of the start
    Panels panels;
    std::string language;
    std::optional<AttractLoop> tour;  ///< flown while nobody touches it, again and again
    double home_after = 60;           ///< seconds
    double touched_at = 0;            ///< seconds
    bool idle = true;                 ///< has returned to the start since then
    bool tours = false;               ///< the flight in progress is the tour, or leads to it
};

/// A kiosk that returns to the session's current settings. Takes away what the public must not reach.
Kiosk make_kiosk(Session& session, std::optional<AttractLoop> tour, double home_after);

/// Ends a tour when somebody touches the window; returns to the start, and tours, when nobody does.
void attend(Kiosk& kiosk, Session& session, bool touched, double now);

/// When attend() is to be called again if nobody touches the window, seconds.
double attends_at(const Kiosk& kiosk);

}  // namespace vantage
