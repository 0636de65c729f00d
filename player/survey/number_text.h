#pragma once
#include <string>

namespace vantage {

/// With this many significant digits, without trailing zeros.
std::string number_text(double value, int digits = 6);
/// With decimals down to the second significant digit of its uncertainty; `uncertainty` is at least 0.
std::string number_text(double value, double uncertainty);
/// With two significant digits.
std::string uncertainty_text(double uncertainty);

}  // namespace vantage
