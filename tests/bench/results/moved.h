#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// A value that differs from an earlier run's by more than its metric's noise.
struct Moved {
    const Measurement* row;  ///< as it is now
    const Metric* metric;
    double before;              ///< a time as if the machine had been as quick then as it is now
    std::optional<double> now;  ///< none: it is no longer measured, or not finite
    double by;                  ///< in multiples of the noise, at most 1e6 either way; positive is worse
    double weight;              ///< 0 to 1, below 1 where it is small beside the sweep's largest such value
};

/// What differs between two runs; points into the rows of the later.
struct Comparison {
    double drift = 1;          ///< how much longer the same takes now: the median ratio of all times
    std::size_t times = 0;     ///< that the median is of; below 5 it is taken to be 1
    std::size_t compared = 0;  ///< values
    std::vector<Moved> moved;  ///< by `by` and `weight`: worst first, most improved last
    std::vector<std::string> appeared, vanished;  ///< settings, or whole scenes of a sweep
};
Comparison compare(std::span<const Measurement> now, std::span<const Measurement> before);

/// A row's name: "border, hall, masks at 1/2, jfa".
std::string full_name(const Measurement& m);

}  // namespace vantage::bench
