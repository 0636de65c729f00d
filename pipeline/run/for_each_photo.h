#pragma once
#include <cstddef>
#include <functional>

namespace vantage {

/// Calls `work(i)` for every i below `count`, on `threads` threads (0: all cores). The first exception ends
/// the rest and is thrown here.
void for_each_photo(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace vantage
