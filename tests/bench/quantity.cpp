#include "tests/bench/quantity.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace vantage::bench {
namespace {

/// Of one family only units of that family are made.
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
    const double middle = std::sqrt(low) * std::sqrt(high) * from->size;
    const Unit* best = nullptr;
    for (const Unit& to : units)
        if (to.family == from->family && (!best || to.size <= middle)) best = &to;
    return {from->size / best->size, best->name};
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "–";
    char text[64];
    const double size = std::abs(value);
    if (size != 0 && (size < 1e-4 || size >= 1e7)) {
        std::snprintf(text, sizeof text, "%.*e", digits - 1, size);
    } else {
        std::snprintf(text, sizeof text, "%.*e", digits - 1, size);  // rounds before it counts the places
        const int places =
            digits - 1 - std::atoi(std::string(text).substr(std::string(text).find('e') + 1).c_str());
        std::snprintf(text, sizeof text, "%.*f", size == 0 ? 0 : std::clamp(places, 0, 9), size);
    }
    return (std::string_view(text).find_first_of("123456789") < std::string_view(text).find('e') && value < 0
                ? "−"
                : "") +
           std::string(text);
}

std::string quantity(double value, const std::string& unit) {
    const double values[] = {std::abs(value)};
    const Scale scale = scale_of(values, unit);
    return number(value * scale.factor) +
           (scale.unit.empty() || !std::isfinite(value) ? "" : " " + scale.unit);
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (c == '<' || c == '>' || c == '&' || c == '"' || c == '\'')
            out += "&#" + std::to_string(int(c)) + ";";
        else
            out += c;
    return out;
}

}  // namespace vantage::bench
