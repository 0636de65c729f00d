#pragma once
#include <vector>

namespace vantage::bench {

/// The mean of the values; 0 if there are none.
template <class T>
double mean(const std::vector<T>& values) {
    double sum = 0;
    for (const T& v : values) sum += double(v);
    return values.empty() ? 0 : sum / double(values.size());
}

}  // namespace vantage::bench
