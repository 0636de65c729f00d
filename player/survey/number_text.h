#pragma once
#include <string>

#include "scene/package/contents/scalar_field.h"

namespace vantage {

/// A number with this many significant digits, without trailing zeros. `size`: the magnitude of such numbers;
/// the digits below its significant digits are noise, and are rounded off. 0: no digit is noise.
std::string number_text(double value, int digits = 6, double size = 0);
/// A number with decimals down to the second significant digit of its uncertainty; `uncertainty` is at least
/// 0.
std::string number_text(double value, double uncertainty);
/// An uncertainty with two significant digits.
std::string uncertainty_text(double uncertainty);
/// A value of a scalar field that is shown with this range.
std::string value_text(double value, const ValueRange& range);

}  // namespace vantage
