#include "player/tour/attract_loop.h"

#include <algorithm>

namespace vantage {

AttractLoop turn_around(const Navigation& start, double seconds, const Arc& arc) {
    constexpr int positions = 720;  // at most half a degree apart
    AttractLoop out{turntable(start, positions, arc), {}, seconds};
    out.positions.push_back(start);
    return out;
}

std::optional<AttractLoop> attract_loop(const Story& story, const Navigation& home, const InputAxes& axes,
                                        const std::string& story_file) {
    if (!story.attract) return {};
    const StoryAttract& attract = *story.attract;
    if (attract.turn > 0) return turn_around(home, attract.turn);
    const auto tour = std::ranges::find(story.tours, attract.tour, &StoryTour::id);
    const auto& stops = tour != story.tours.end() ? tour->stops : attract.stops;
    if (stops.empty()) return {};
    auto along = std::make_shared<const CameraSpline>(keys_of(story, stops, {}, axes, story_file));
    AttractLoop out{{}, along, along->seconds()};
    out.tour.stops = stops;
    out.tour.stops.front().fly = 0;
    return out;
}

}  // namespace vantage
