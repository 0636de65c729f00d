#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <mutex>

namespace vantage {

/// The number of bytes per second over the last two seconds. Thread-safe.
class Rate {
  public:
    void add(std::uint64_t bytes) {
        const std::scoped_lock lock(mutex_);
        const std::int64_t time = now();
        Slot& slot = slots_[std::size_t(time) % slots_.size()];
        if (slot.time != time) slot = {time, 0};
        slot.bytes += bytes;
    }

    double per_second() const {
        const std::scoped_lock lock(mutex_);
        const std::int64_t time = now();
        std::uint64_t bytes = 0;
        for (const Slot& slot : slots_)
            if (slot.time > time - std::int64_t(slots_.size())) bytes += slot.bytes;
        return double(bytes) * slots_per_second / double(slots_.size());
    }

  private:
    static constexpr int slots_per_second = 4;
    struct Slot {
        std::int64_t time = -1'000'000;  ///< number of slots since the clock started
        std::uint64_t bytes = 0;
    };
    static std::int64_t now() {
        using namespace std::chrono;
        return floor<milliseconds>(steady_clock::now().time_since_epoch()).count() * slots_per_second / 1000;
    }
    mutable std::mutex mutex_;
    std::array<Slot, 8> slots_{};
};

}  // namespace vantage
