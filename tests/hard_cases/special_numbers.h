#pragma once
#include <limits>

namespace vantage {

inline constexpr double infinite = std::numeric_limits<double>::infinity(),
                        not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace vantage
