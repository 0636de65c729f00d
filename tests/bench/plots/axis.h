#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/quantity.h"

namespace vantage::bench {

/// An axis of a plot: its range in `scale.unit`, wider than the values.
struct Axis {
    struct Tick {
        double at;  ///< in `scale.unit`
        std::string text;
    };
    Scale scale;
    bool log = false;
    double low = 0, high = 1;
    std::optional<double> floor;  ///< where values <= 0 are drawn on a log axis that has some
    std::vector<Tick> ticks;
};

/// For values in `unit`; those that are not finite do not count. Logarithmic if wished and any is positive.
Axis axis_of(std::span<const double> values, bool log, const std::string& unit);

/// Where a value is drawn, in `scale.unit`.
double drawn_at(const Axis& axis, double value);
/// Such a place as a share of the axis' length, from its low end.
double share_along(const Axis& axis, double at);

}  // namespace vantage::bench
