#include "player/survey/number_text.h"

#include <algorithm>
#include <cmath>

#include "base/text/formatted.h"

namespace vantage {
namespace {

/// Decimals down to the second significant digit, at most twelve. 0.00996 is written as 0.010.
int decimals_for(double uncertainty) {
    if (!(uncertainty > 0)) return 6;
    return int(std::clamp(1 - std::floor(std::log10(uncertainty * 1.005)), 0.0, 12.0));
}

std::string with_decimals(double value, int decimals) { return formatted("%.*f", decimals, value); }

}  // namespace

std::string number_text(double value, int digits, double size) {
    const double last = std::pow(10, std::floor(std::log10(size)) + 1 - digits);
    const double rounded = std::round(value / last) * last;
    return formatted("%.*g", digits, size > 0 && std::isfinite(rounded) ? rounded : value);
}

std::string number_text(double value, double uncertainty) {
    return with_decimals(value, decimals_for(uncertainty));
}

std::string uncertainty_text(double uncertainty) {
    return with_decimals(uncertainty, decimals_for(uncertainty));
}

std::string value_text(double value, const ValueRange& range) {
    return number_text(value, 5, std::max(std::abs(range.low), std::abs(range.high)));
}

}  // namespace vantage
