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

/// What is read of photos, each when it is wanted; those that were wanted last stay. Thread-safe.
template <class T>
class LruCache {
  public:
    LruCache(std::size_t most, std::function<T(std::uint32_t photo)> read)
        : most_(most), read_(std::move(read)) {}

    std::shared_ptr<const T> get(std::uint32_t photo) {
        {
            const std::scoped_lock lock(mutex_);
            const auto known = std::ranges::find(entries_, photo, &Entry::first);
            if (known != entries_.end()) {
                entries_.splice(entries_.begin(), entries_, known);
                return entries_.front().second;
            }
        }
        const auto read = std::make_shared<const T>(read_(photo));
        const std::scoped_lock lock(mutex_);
        entries_.emplace_front(photo, read);
        if (entries_.size() > most_) entries_.pop_back();
        return read;
    }

  private:
    using Entry = std::pair<std::uint32_t, std::shared_ptr<const T>>;
    std::size_t most_;
    std::function<T(std::uint32_t photo)> read_;
    std::mutex mutex_;
    std::list<Entry> entries_;
};

}  // namespace vantage
