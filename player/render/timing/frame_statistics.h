#pragma once
#include <vector>

namespace vantage {

/// Statistics of frame times, or of other values with important rare extremes.
struct FrameStatistics {
    double mean = 0, median = 0, p99 = 0, p999 = 0, max = 0;
};
/// Percentiles by nearest rank; all 0 if there are no values.
FrameStatistics frame_statistics(std::vector<double> values);

}  // namespace vantage
