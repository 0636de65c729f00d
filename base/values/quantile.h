#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace vantage {

/// The value at rank floor(share (n - 1)) of the n sorted values; `share` is in [0, 1]. If n is even, a share
/// of 0.5 gives the lower of the two middle values. Returns 0 if there are no values.
template <class T>
double quantile(std::vector<T> values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() + std::ptrdiff_t(std::clamp(share, 0.0, 1.0) * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return double(*at);
}

/// The median, or the upper of the two middle values if their number is even; 0 if there are no values.
/// Reorders the values.
template <class T>
T upper_median(std::span<T> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The jackknife standard error of an estimate: sqrt((n - 1) / n sum(d^2)), where each d is the difference
/// between the estimate and one of n estimates that omit part of the data. Returns 0 if there are no
/// differences.
inline double jackknife_error(std::span<const double> distances) {
    const double n = double(distances.size());
    double squares = 0;
    for (const double d : distances) squares += d * d;
    return n > 0 ? std::sqrt(squares * (n - 1) / n) : 0;
}

}  // namespace vantage
