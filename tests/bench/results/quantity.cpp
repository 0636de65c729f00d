#include "tests/bench/results/quantity.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace vantage::bench {
namespace {

/// Units are converted only within their family.
struct Unit {
    const char* name;
    char family;
    double size;
};
constexpr Unit units[] = {{"B", 'b', 1},     {"kB", 'b', 1e3},  {"MB", 'b', 1e6},  {"GB", 'b', 1e9},
                          {"ns", 't', 1e-9}, {"µs", 't', 1e-6}, {"ms", 't', 1e-3}, {"s", 't', 1}};

}  // namespace

Scale scale_of(std::span<const double> values, const std::string& unit) {
    const Unit* from = std::ranges::find(units, unit, &Unit::name);
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const double v : values)
        if (std::isfinite(v) && v > 0) low = std::min(low, v), high = std::max(high, v);
    if (from == std::end(units) || high == 0) return {1, unit};
    const double middle = std::sqrt(low) * std::sqrt(high) * from->size, most = high * from->size;
    const Unit* best = nullptr;
    for (const Unit& to : units)
        if (to.family == from->family && (!best || (to.size <= 10 * middle && to.size <= most))) best = &to;
    return {from->size / best->size, best->name};
}

std::string power_of_ten(int exponent) {
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = exponent < 0 ? "10⁻" : "10";
    for (const char c : std::to_string(std::abs(exponent))) out += digits[c - '0'];
    return out;
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "–";
    if (value == 0) return "0";
    char rounded[64], text[64];
    std::snprintf(rounded, sizeof rounded, "%.*e", digits - 1, std::abs(value));
    const std::string_view r = rounded;
    const int exponent = std::atoi(rounded + r.find('e') + 1), places = digits - 1 - exponent;
    const std::string minus = value < 0 ? "−" : "";
    if (exponent < -4 || exponent > 6)
        return minus + std::string(r.substr(0, r.find('e'))) + "·" + power_of_ten(exponent);
    std::snprintf(text, sizeof text, "%.*f", std::max(places, 0), std::abs(value));
    return minus + text;
}

std::string quantity(double value, const std::string& unit, int digits) {
    const double values[] = {std::abs(value)};
    const Scale scale = scale_of(values, unit);
    return number(value * scale.factor, digits) +
           (scale.unit.empty() || !std::isfinite(value) ? "" : " " + scale.unit);
}

}  // namespace vantage::bench
