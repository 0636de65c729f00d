#include "tests/bench/measure/timing.h"

#include "base/values/quantile.h"

namespace vantage::bench {

std::vector<double> medians_in_turn(std::size_t settings, int repeats,
                                    const std::function<double(std::size_t)>& time) {
    std::vector<std::vector<double>> rounds(settings);
    for (int r = 0; r < repeats; ++r)
        for (std::size_t i = 0; i < settings; ++i) rounds[i].push_back(time(i));
    std::vector<double> out;
    for (std::vector<double>& r : rounds) out.push_back(quantile(std::move(r), 0.5));
    return out;
}

}  // namespace vantage::bench
