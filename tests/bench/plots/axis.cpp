#include "tests/bench/plots/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string_view>

namespace vantage::bench {
namespace {

constexpr double padding = 0.07;
constexpr double least = 1e-100, most = 1e100;  // larger ranges would overflow

std::string with_places(double value, int places) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", std::clamp(places, 0, 12), std::abs(value));
    const bool zero = std::string_view(text).find_first_of("123456789") == std::string_view::npos;
    return (value < 0 && !zero ? "−" : "") + std::string(text);
}

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `least`.
double round_step(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * decade >= least * (1 - 1e-9)) return m * decade;
    return 10 * decade;
}

std::vector<Axis::Tick> even_ticks(double low, double high) {
    const double step = round_step((high - low) / 6);
    const int places = std::max(0, -int(std::floor(std::log10(step) + 1e-9)));
    std::vector<Axis::Tick> out;
    for (double i = std::ceil(low / step); i * step <= high; ++i)
        out.push_back({i * step, with_places(i * step, places)});
    return out;
}

std::vector<Axis::Tick> log_ticks(double low, double high) {
    const double decades = std::log10(high) - std::log10(low);
    if (decades < 1) return even_ticks(low, high);
    const int every = std::max(1, int(std::ceil(decades / 7)));
    const bool plain = low >= 0.9e-3 && high < 1.1e5;
    std::vector<Axis::Tick> out;
    for (int e = int(std::floor(std::log10(low))); std::pow(10.0, e) <= high; ++e)
        for (const double m : {1.0, 2.0, 5.0}) {
            const double at = m * std::pow(10.0, e);
            if (at < low || at > high || (m > 1 && decades > 3) || (m == 1 && e % every)) continue;
            out.push_back({at, plain    ? with_places(at, std::max(0, -e))
                               : m == 1 ? power_of_ten(e)
                                        : with_places(m, 0) + "·" + power_of_ten(e)});
        }
    return out;
}

/// Values within 1e-4 of each other are drawn as one, because ticks between them would need many digits.
void set_even_range(Axis& axis, double low, double high) {
    const double size = std::max(std::abs(low), std::abs(high)), middle = low / 2 + high / 2;
    const bool positive = low >= 0;
    if (size < least) low = 0, high = 1;
    if (high - low < 1e-4 * size) low = middle - 0.1 * size, high = middle + 0.1 * size;
    const double pad = padding * (high - low);
    axis.low = positive && low - pad < 0 ? -0.4 * pad : low - pad;
    axis.high = high + pad;
    axis.ticks = even_ticks(axis.low, axis.high);
}

void set_log_range(Axis& axis, double low, double high, bool zeros, bool negatives) {
    if (high < low * 1.001) low /= 2, high *= 2;
    const double decades = std::log10(high) - std::log10(low), wider = std::pow(10.0, padding * decades);
    if (zeros) {
        axis.floor = low / std::max(2.0, std::pow(10.0, 0.14 * decades));
        axis.low = *axis.floor / wider;
    } else {
        axis.low = low / wider;
    }
    axis.high = high * wider;
    axis.ticks = log_ticks(zeros ? low * 0.98 : axis.low, axis.high);
    if (zeros) axis.ticks.insert(axis.ticks.begin(), {*axis.floor, negatives ? "≤ 0" : "0"});
}

}  // namespace

Axis axis_of(std::span<const double> values, bool log, const std::string& unit) {
    Axis axis;
    axis.scale = scale_of(values, unit);
    std::vector<double> all, positive;
    for (const double v : values)
        if (std::isfinite(v)) all.push_back(std::clamp(v * axis.scale.factor, -most, most));
    std::ranges::copy_if(all, std::back_inserter(positive), [](double v) { return v >= least; });
    axis.log = log && !positive.empty();
    if (all.empty()) return axis;
    const auto [low, high] = std::ranges::minmax(axis.log ? positive : all);
    if (axis.log)
        set_log_range(axis, low, high, positive.size() < all.size(), std::ranges::min(all) < 0);
    else
        set_even_range(axis, low, high);
    return axis;
}

double drawn_at(const Axis& axis, double value) {
    const double at = std::clamp(value * axis.scale.factor, -most, most);
    return axis.log && at < least ? axis.floor.value_or(axis.low) : at;
}

double share_along(const Axis& axis, double at) {
    return axis.log ? (std::log(at) - std::log(axis.low)) / (std::log(axis.high) - std::log(axis.low))
                    : (at - axis.low) / (axis.high - axis.low);
}

}  // namespace vantage::bench
