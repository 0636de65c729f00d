#pragma once
#include <cmath>

namespace vantage {

/// The smallest 1, 2 or 5 times a power of ten that is at least `value`, which must be positive.
inline double round_up(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= value) return digit * power;
    return 10 * power;
}

}  // namespace vantage
