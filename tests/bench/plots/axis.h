#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/quantity.h"

namespace vantage::bench {

/// An axis of a plot. Its range, in `scale.unit`, extends slightly beyond the values.
struct Axis {
    struct Tick {
        double at;  ///< position in `scale.unit`
        std::string text;
    };
    Scale scale;
    bool log = false;
    double low = 0, high = 1;
    std::optional<double> floor;  ///< position of values <= 0 on a logarithmic axis, if there are any
    std::vector<Tick> ticks;
};

/// An axis for values in `unit`; values that are not finite are ignored. The axis is logarithmic if `log` is
/// set and any value is positive.
Axis axis_of(std::span<const double> values, bool log, const std::string& unit);

/// The position of a value on the axis, in `scale.unit`.
double drawn_at(const Axis& axis, double value);
/// The position `at` as a fraction of the axis length, measured from the low end.
double share_along(const Axis& axis, double at);

}  // namespace vantage::bench
