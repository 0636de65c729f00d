#pragma once
#include <cstddef>

#include "scene/story/story.h"

namespace vantage {

/// The stop that a tour flies to or stays at, counted from 0, and its arrival time in seconds.
struct TourStop {
    std::size_t stop;
    double reached;
};
/// The state `seconds` after the tour's start; after the tour's end, the last stop. The tour must have at
/// least one stop.
TourStop tour_stop(const StoryTour& tour, double seconds);

}  // namespace vantage
