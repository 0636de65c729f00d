#pragma once
#include <string>

namespace vantage {

/// A number with this many significant digits, without trailing zeros.
std::string number_text(double value, int digits = 6);
/// A number with decimals down to the second significant digit of its uncertainty; `uncertainty` is at least
/// 0.
std::string number_text(double value, double uncertainty);
/// An uncertainty with two significant digits.
std::string uncertainty_text(double uncertainty);

}  // namespace vantage
