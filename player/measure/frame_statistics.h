#pragma once
#include <vector>

namespace vantage {

/// Frame times, or anything else of which the rare matter: an average says little.
struct FrameStatistics {
    double mean = 0, median = 0, p99 = 0, p999 = 0, max = 0;
};
/// Percentiles by the nearest rank; all 0 for none.
FrameStatistics frame_statistics(std::vector<double> values);

}  // namespace vantage
