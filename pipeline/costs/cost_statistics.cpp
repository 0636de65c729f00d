#include "pipeline/costs/cost_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text/parse_number.h"
#include "base/values/quantile.h"

namespace vantage {
namespace {

/// The 97.5 % quantile of Student's t distribution with `n` degrees of freedom; `n` is at least 1. Above 30,
/// the value for 30 is returned.
double t_quantile(std::size_t n) {
    constexpr double table[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
    return table[std::min(n, std::size(table)) - 1];
}

CostRatio ratio(const std::optional<double>& a, const std::optional<double>& b) {
    if (!a || !b || !(*a > 0) || !(*b > 0)) return {};
    return *a / *b;
}

/// The 90th percentile of the relative differences between successive times, but at least 5 %.
double noise_of(std::span<const ScanCosts> scans, double (*time_of)(const TrialCosts&)) {
    std::vector<double> changes;
    for (const ScanCosts& scan : scans) {
        double last = 0;
        for (const TrialCosts& c : scan.trials) {
            const double time = time_of(c);
            if (last > 0 && time > 0) changes.push_back(std::abs(std::log(time / last)));
            if (time > 0) last = time;
        }
    }
    constexpr double least = 0.05;
    return changes.empty() ? least : std::max(least, std::exp(quantile(changes, 0.9)) - 1);
}

/// The value by which trials on different scans are pooled. A photo size becomes a fraction of the scan's
/// full size if it is a half or a quarter.
std::string common_value(const CostTrial& trial, const ScanCosts& scan) {
    int side = 0;
    if (trial.setting != "--max-photo-size" || !parse_number(trial.value, side) || side <= 0)
        return trial.value;
    const double parts = std::max(scan.width, scan.height) / double(side);
    return std::lround(parts) == 2 ? "half" : std::lround(parts) == 4 ? "a quarter" : trial.value;
}

struct Sum {
    double logarithms = 0;
    int values = 0;
    void add(const CostRatio& r) {
        if (!r) return;
        logarithms += std::log(*r);
        ++values;
    }
    CostRatio mean() const {
        if (values == 0) return {};
        return std::exp(logarithms / values);
    }
};

}  // namespace

double standard_error(std::span<const double> values) {
    const double n = double(values.size());
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / n;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return std::sqrt(squares / (n - 1) / n);
}

std::optional<MeanWithError> estimate(std::span<const double> values) {
    const std::size_t n = values.size();
    if (n == 0) return {};
    MeanWithError out{0, std::numeric_limits<double>::infinity(), n};
    for (const double v : values) out.mean += v / double(n);
    if (n > 1) out.error = t_quantile(n - 1) * standard_error(values);
    return out;
}

bool certain(const MeanWithError& e) { return std::abs(e.mean) > e.error; }

double median_of(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

double least_of(std::span<const double> seconds) {
    return seconds.empty() ? 0 : *std::ranges::min_element(seconds);
}

CostRatio seconds_ratio(const TrialCosts& trial, const TrialCosts& defaults) {
    return ratio(least_of(trial.prepare_seconds),
                 least_of(trial.default_seconds.empty() ? defaults.prepare_seconds : trial.default_seconds));
}
CostRatio bytes_ratio(const TrialCosts& trial, const TrialCosts& defaults) {
    return ratio(trial.package_bytes, defaults.package_bytes);
}
CostRatio memory_ratio(const TrialCosts& trial, const TrialCosts& defaults) {
    return ratio(trial.memory_bytes, defaults.memory_bytes);
}
CostRatio frame_ratio(const TrialCosts& trial, const TrialCosts& defaults) {
    return ratio(median_of(trial.frame_ms),
                 median_of(trial.default_ms.empty() ? defaults.frame_ms : trial.default_ms));
}

std::vector<PooledTrial> pooled_trials(std::span<const ScanCosts> scans) {
    struct Pool {
        PooledTrial out;
        Sum seconds, bytes, memory, frame;
        std::vector<double> psnr;
    };
    std::vector<Pool> pools;
    for (const ScanCosts& scan : scans)
        for (const TrialCosts& c : scan.trials) {
            CostTrial common = c.trial;
            common.value = common_value(c.trial, scan);
            auto at = std::ranges::find_if(pools, [&](const Pool& p) {
                return p.out.trial.setting == common.setting && p.out.trial.value == common.value;
            });
            if (at == pools.end()) {
                at = pools.emplace(pools.end());
                at->out.trial = common;
            }
            const TrialCosts& defaults = scan.trials.front();
            at->seconds.add(seconds_ratio(c, defaults));
            at->bytes.add(bytes_ratio(c, defaults));
            at->memory.add(memory_ratio(c, defaults));
            at->frame.add(frame_ratio(c, defaults));
            at->psnr.insert(at->psnr.end(), c.psnr.begin(), c.psnr.end());
            if (const auto of_scan = estimate(c.psnr)) at->out.psnr_of_scans.push_back(of_scan->mean);
            at->out.scans.push_back(scan.name);
        }
    std::vector<PooledTrial> out;
    for (Pool& p : pools) {
        p.out.seconds = p.seconds.mean();
        p.out.bytes = p.bytes.mean();
        p.out.memory = p.memory.mean();
        p.out.frame = p.frame.mean();
        p.out.psnr = estimate(p.psnr);
        out.push_back(std::move(p.out));
    }
    return out;
}

double noise_of_seconds(std::span<const ScanCosts> scans) {
    return noise_of(scans, [](const TrialCosts& c) { return least_of(c.default_seconds); });
}

double noise_of_frames(std::span<const ScanCosts> scans) {
    return noise_of(scans, [](const TrialCosts& c) { return median_of(c.default_ms); });
}

}  // namespace vantage
