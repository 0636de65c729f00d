#pragma once
#include <span>
#include <string>

namespace vantage::bench {

/// A unit that numbers of one quantity are easily read in.
struct Scale {
    double factor = 1;  ///< times a value in the metric's unit
    std::string unit;
};

/// For values in `unit`: bytes become kB, MB or GB, times ns to s; any other unit stays. The largest in
/// which the greatest value is no less than 1 and the middle, by ratio, no less than a tenth. Values that are
/// not positive and finite do not count.
Scale scale_of(std::span<const double> values, const std::string& unit);

/// "10⁻⁷"
std::string power_of_ten(int exponent);
/// To that many significant digits, an en dash for what is not finite; a minus sign is one.
std::string number(double value, int digits = 4);
/// With its unit: "12.3 MB".
std::string quantity(double value, const std::string& unit, int digits = 4);

}  // namespace vantage::bench
