#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

namespace vantage {

/// Caches data of photos, which is read on demand. The data of the least recently used photo is evicted. The
/// cache is thread-safe, but two threads that request the same photo at once may both read it.
template <class T>
class LruCache {
  public:
    /// `capacity`: number of photos.
    LruCache(std::size_t capacity, std::function<T(std::uint32_t photo)> read)
        : capacity_(capacity), read_(std::move(read)) {}

    std::shared_ptr<const T> get(std::uint32_t photo) const {
        {
            const std::scoped_lock lock(mutex_);
            const auto found = std::ranges::find(entries_, photo, &Entry::first);
            if (found != entries_.end()) {
                entries_.splice(entries_.begin(), entries_, found);
                return entries_.front().second;
            }
        }
        const auto data = std::make_shared<const T>(read_(photo));
        const std::scoped_lock lock(mutex_);
        entries_.emplace_front(photo, data);
        if (entries_.size() > capacity_) entries_.pop_back();
        return data;
    }

  private:
    using Entry = std::pair<std::uint32_t, std::shared_ptr<const T>>;
    std::size_t capacity_;
    std::function<T(std::uint32_t photo)> read_;
    mutable std::mutex mutex_;
    mutable std::list<Entry> entries_;  ///< most recently used first
};

}  // namespace vantage
