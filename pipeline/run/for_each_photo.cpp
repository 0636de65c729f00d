#include "pipeline/run/for_each_photo.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace vantage {

void for_each_photo(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex mutex;
    const auto work_on_next = [&] {
        for (std::size_t i; (i = next++) < count;) try {
                work(i);
            } catch (...) {
                const std::scoped_lock lock(mutex);
                if (!failure) failure = std::current_exception();
                next = count;
            }
    };
    {
        std::vector<std::jthread> others;
        try {
            for (std::size_t t = 1; t < std::min<std::size_t>(threads, count); ++t)
                others.emplace_back(work_on_next);
        } catch (const std::system_error&) {
            // The system cannot start more threads; those already started do the work.
        }
        work_on_next();
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace vantage
