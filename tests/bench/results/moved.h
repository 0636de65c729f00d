#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// A measured value that differs from the value in an earlier run by more than the noise of its metric.
struct Moved {
    const Measurement* row;  ///< current row
    const Metric* metric;
    double before;              ///< the earlier value; times are multiplied by the drift
    std::optional<double> now;  ///< nullopt if the value is no longer measured or not finite
    double by;                  ///< change as a multiple of the noise, clamped to 1e6; positive means worse
    double weight;              ///< 0 to 1; below 1 for values under 1 % of the sweep's largest value
};

/// The differences between two runs; points into the rows of the later run.
struct Comparison {
    double drift = 1;          ///< median of the ratios of later to earlier times
    std::size_t times = 0;     ///< number of timings from which `drift` is computed; if fewer than 5, it is 1
    std::size_t compared = 0;  ///< number of values
    std::vector<Moved> moved;  ///< sorted by `by` times `weight`: worst first, most improved last
    std::vector<std::string> appeared, vanished;  ///< settings, or whole scenes of a sweep
};
Comparison compare(std::span<const Measurement> now, std::span<const Measurement> before);

/// The full name of a row: "border, hall, weight maps at 1/2, jfa".
std::string full_name(const Measurement& m);

}  // namespace vantage::bench
