#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// A value that differs from its value in an earlier run by more than the noise of its metric.
struct Moved {
    const Measurement* row;  ///< current row
    const Metric* metric;
    double before;              ///< times are multiplied by the drift
    std::optional<double> now;  ///< nullopt if it is no longer measured, or non-finite
    double by;                  ///< change in multiples of the noise, limited to 1e6; positive is worse
    double weight;              ///< 0 to 1; below 1 for values under 1 % of the sweep's largest
};

/// The differences between two runs; points into the rows of the later one.
struct Comparison {
    double drift = 1;          ///< median ratio of all times, now over before
    std::size_t times = 0;     ///< number of times behind `drift`, which is 1 if there are fewer than 5
    std::size_t compared = 0;  ///< number of values
    std::vector<Moved> moved;  ///< sorted by `by` times `weight`: worst first, most improved last
    std::vector<std::string> appeared, vanished;  ///< settings, or whole scenes of a sweep
};
Comparison compare(std::span<const Measurement> now, std::span<const Measurement> before);

/// The full name of a row: "border, hall, weight maps at 1/2, jfa".
std::string full_name(const Measurement& m);

}  // namespace vantage::bench
