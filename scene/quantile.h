#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace vantage {

/// The value that the share `share` of all is below; 0 for none.
template <class T>
double quantile(std::vector<T> values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() + std::ptrdiff_t(std::clamp(share, 0.0, 1.0) * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return double(*at);
}

}  // namespace vantage
