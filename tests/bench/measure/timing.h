#pragma once
#include <chrono>
#include <functional>
#include <vector>

namespace vantage::bench {

/// Milliseconds that `work` takes.
template <class Work>
double milliseconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Medians of `repeats` rounds over all settings, in turn, so that a machine that drifts does so for all.
/// `time(i)` gives the milliseconds of setting i.
std::vector<double> medians_in_turn(std::size_t settings, int repeats,
                                    const std::function<double(std::size_t)>& time);

}  // namespace vantage::bench
