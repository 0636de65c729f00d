#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace vantage::bench {

/// Selects `count` of the values, evenly spread and in order; all values if there are no more than `count`.
template <class T>
std::vector<T> evenly_spread(const std::vector<T>& values, std::size_t count) {
    const std::size_t all = values.size(), some = std::min(count, all);
    std::vector<T> out;
    for (std::size_t i = 0; i < some; ++i) out.push_back(values[(2 * i + 1) * all / (2 * some)]);
    return out;
}

}  // namespace vantage::bench
