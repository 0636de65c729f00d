#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package/package_reader.h"
#include "tests/bench/results/measurement.h"

namespace vantage::bench {

using Bytes = std::vector<std::uint8_t>;
using Texels = std::span<const std::uint8_t>;  ///< RGBA, row by row

/// Accumulates the absolute differences between the channels and the truth, clamped to 255.
class Differences {
  public:
    void add(double difference) {
        squares_ += difference * difference;
        ++counts_[std::size_t(std::lround(std::min(std::abs(difference), 255.0) * steps))];
        ++all_;
    }
    bool empty() const { return all_ == 0; }
    double psnr() const {
        const double mean = squares_ / double(std::max(all_, std::uint64_t(1)));
        return mean > 0 ? std::min(psnr_cap, 10 * std::log10(255 * 255 / mean)) : psnr_cap;
    }
    /// The 99.9th percentile of the absolute differences.
    double worst() const {
        std::uint64_t up_to = 0;
        for (std::size_t i = 0; i < counts_.size(); ++i)
            if ((up_to += counts_[i]) * 1000 >= all_ * 999) return double(i) / steps;
        return 255;
    }

  private:
    static constexpr std::size_t steps = 16;  ///< per gray level
    double squares_ = 0;
    std::uint64_t all_ = 0;
    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(255 * steps + 1);
};

/// At most `count` of the photos that have tiles, evenly spread.
std::vector<std::uint32_t> some_photos(const PackageReader& package, std::size_t count);

}  // namespace vantage::bench
