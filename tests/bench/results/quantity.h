#pragma once
#include <span>
#include <string>

namespace vantage::bench {

/// A readable unit for a set of values.
struct Scale {
    double factor = 1;  ///< factor that converts from the metric's unit to `unit`
    std::string unit;
};

/// For values in `unit`, the largest unit from B to GB or from ns to s in which the maximum is at least 1 and
/// the geometric mean of minimum and maximum is at least 0.1. Any other unit is kept. Values that are not
/// positive and finite are ignored.
Scale scale_of(std::span<const double> values, const std::string& unit);

/// "10⁻⁷"
std::string power_of_ten(int exponent);
/// The value rounded to `digits` significant digits, with a true minus sign; an en dash if it is not finite.
std::string number(double value, int digits = 4);
/// The value with its unit: "12.3 MB".
std::string quantity(double value, const std::string& unit, int digits = 4);

}  // namespace vantage::bench
