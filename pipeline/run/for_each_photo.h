#pragma once
#include <cstddef>
#include <functional>

namespace vantage {

/// Calls `work(i)` for every i below `count` on `threads` threads (0: one per core), including the calling
/// thread, or on fewer if the system cannot start them. After an exception, no further calls are started; the
/// first exception is rethrown when all threads have finished.
void for_each_photo(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace vantage
