#include "player/window/kiosk.h"

#include <cmath>
#include <utility>

namespace vantage {

Kiosk make_kiosk(Session& s, std::optional<AttractLoop> tour, double home_after) {
    s.window.kiosk = s.window.full_screen = true;
    s.window.panels.expert = s.window.panels.frusta = s.window.panels.radar = s.window.panels.help = false;
    s.window.panels.bar = true;
    return {s.settings, s.window.panels, s.window.language, std::move(tour), home_after};
}

namespace {

/// Flies along the tour, or to its start.
void start_tour(Kiosk& k, Session& s, double now) {
    const Navigation begin = k.tour->begin();
    const bool at_start = s.viewpoint.camera.eye == begin.eye && s.viewpoint.camera.R == begin.R;
    s.viewpoint.flight = at_start ? Viewpoint::Flight{k.tour->along ? std::vector{begin} : k.tour->positions,
                                                      now, k.tour->seconds, k.tour->along}
                                  : Viewpoint::Flight{{s.viewpoint.camera, begin}, now, 2};
    k.tours = true;
}

}  // namespace

bool attend(Kiosk& k, Session& s, ActiveStory& active, bool touched, double now) {
    if (touched) {
        if (k.tours) fly_home(s, now);  // unless the touch moves the view
        k.idle = k.tours = false;
    }
    if (touched || active.playing) k.touched_at = now;
    if (now - k.touched_at < k.home_after) return false;
    const bool restores = !std::exchange(k.idle, true);
    if (restores) {
        s.settings = k.settings;
        s.window.panels = k.panels;
        s.window.language = k.language;
        s.viewpoint.earlier.views.clear();
        s.window.commands.push_back(CloseMenus{});
        active.open.reset();
        fly_home(s, now);
    }
    if (k.tour && !s.viewpoint.flight) start_tour(k, s, now);
    return restores;
}

double attends_at(const Kiosk& k) { return k.idle && !k.tour ? HUGE_VAL : k.touched_at + k.home_after; }

}  // namespace vantage
