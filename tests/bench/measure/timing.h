#pragma once
#include <chrono>
#include <functional>
#include <vector>

namespace vantage::bench {

/// The wall-clock time of `work` in milliseconds.
template <class Work>
double milliseconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The median time of each setting over `repeats` rounds. Each round measures all settings in turn, so that
/// changes in the machine's speed affect them equally. `time(i)` returns the time of setting i in
/// milliseconds.
std::vector<double> medians_in_turn(std::size_t settings, int repeats,
                                    const std::function<double(std::size_t)>& time);

}  // namespace vantage::bench
