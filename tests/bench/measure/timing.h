#pragma once
#include <chrono>
#include <functional>
#include <vector>

namespace vantage::bench {

/// Wall time of `work`, milliseconds.
template <class Work>
double milliseconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Median time of each setting over `repeats` rounds. Each round times all settings in turn, so that drift of
/// the machine affects them equally. `time(i)` returns the milliseconds of setting i.
std::vector<double> medians_in_turn(std::size_t settings, int repeats,
                                    const std::function<double(std::size_t)>& time);

}  // namespace vantage::bench
