#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace vantage {

/// The smallest and the largest of several values. The range is empty (low > high) if there are no values.
struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    /// Ignores values that are not finite.
    void add(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool empty() const { return low > high; }
};

}  // namespace vantage
