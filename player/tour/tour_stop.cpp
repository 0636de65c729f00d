#include "player/tour/tour_stop.h"

namespace vantage {

TourStop tour_stop(const StoryTour& tour, double seconds) {
    double left = 0;  // of the previous stop
    for (std::size_t i = 0;; ++i) {
        const StoryStop& stop = tour.stops[i];
        const double reached = left + stop.fly;
        left = reached + stop.stay;
        if (seconds < left || i + 1 == tour.stops.size()) return {i, reached};
    }
}

}  // namespace vantage
