#pragma once
#include <vector>

namespace vantage {

/// Statistics of frame times, or of other values whose rare extremes matter.
struct FrameStatistics {
    double mean = 0, median = 0, p99 = 0, p999 = 0, max = 0;
};
/// Percentiles use the nearest-rank method; all are 0 if there are no values.
FrameStatistics frame_statistics(std::vector<double> values);

}  // namespace vantage
