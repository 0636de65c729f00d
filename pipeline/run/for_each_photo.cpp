#include "pipeline/run/for_each_photo.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vantage {

void for_each_photo(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex mutex;
    {
        std::vector<std::jthread> pool;
        for (unsigned t = 0; t < threads; ++t)
            pool.emplace_back([&] {
                for (std::size_t i; (i = next++) < count;) try {
                        work(i);
                    } catch (...) {
                        const std::scoped_lock lock(mutex);
                        if (!failure) failure = std::current_exception();
                        next = count;
                    }
            });
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace vantage
