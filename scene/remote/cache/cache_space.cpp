#include "scene/remote/cache/cache_space.h"

#include <algorithm>

namespace vantage {

CacheSpace::CacheSpace(const CacheFolder& folder, CachedFile& file, std::uint64_t limit)
    : folder_(folder), file_(file), limit_(limit) {}

void CacheSpace::reserve(std::uint64_t bytes) {
    constexpr std::uint64_t count_every = 64 << 20;  // bytes
    const std::scoped_lock lock(mutex_);
    const std::uint64_t due = reserved_ + bytes;
    if (until_count_ == 0 || on_disk_ + due > limit_) {
        const std::uint64_t most = limit_ - std::min(limit_, due);
        on_disk_ = folder_.prune(most);
        if (on_disk_ > most)  // frees more than necessary, so that the next eviction is not due soon
            on_disk_ -= std::min(on_disk_, file_.evict(on_disk_ - most + limit_ / 16));
        until_count_ = count_every;
    }
    reserved_ += bytes;
}

void CacheSpace::settle(std::uint64_t bytes) {
    const std::scoped_lock lock(mutex_);
    reserved_ -= bytes;
    on_disk_ += bytes;
    until_count_ -= std::min(until_count_, bytes);
}

}  // namespace vantage
