#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/costs/costs.h"

namespace vantage {

/// A mean and half the width of its 95 % confidence interval (Student's t), which is infinite for a single
/// value.
struct MeanWithError {
    double mean = 0, error = 0;
    std::size_t values = 0;
};
/// nullopt if there are no values.
std::optional<MeanWithError> estimate(std::span<const double> values);
/// Standard error of the mean of at least two values.
double standard_error(std::span<const double> values);
/// Whether the confidence interval excludes zero.
bool certain(const MeanWithError& e);

double median_of(std::vector<double> values);
/// The least of some durations, which other programs can only lengthen; 0 if there are none.
double least_of(std::span<const double> seconds);

/// A cost of a trial divided by that of the defaults; nullopt if either was not measured or is zero.
using CostRatio = std::optional<double>;
CostRatio seconds_ratio(const TrialCosts& trial, const TrialCosts& defaults);
CostRatio bytes_ratio(const TrialCosts& trial, const TrialCosts& defaults);
CostRatio memory_ratio(const TrialCosts& trial, const TrialCosts& defaults);
CostRatio frame_ratio(const TrialCosts& trial, const TrialCosts& defaults);

/// The costs of one trial relative to the defaults, combined over all scans on which it was measured.
struct PooledTrial {
    CostTrial trial;
    CostRatio seconds, bytes, memory, frame;  ///< geometric means over the scans
    std::optional<MeanWithError> psnr;        ///< differences from the defaults, over all photos of all scans
    std::vector<double> psnr_of_scans;        ///< their mean on each scan
    std::vector<std::string> scans;           ///< names
};
/// Pools the trials that have the same setting and value; reduced photo sizes are the same if they are the
/// same fraction of the full size. The result is in the order of the first scan's trials, the defaults first.
std::vector<PooledTrial> pooled_trials(std::span<const ScanCosts> scans);

/// The 90th percentile of the relative differences between successive times of the defaults, at least 0.05.
/// Each trial has one time: that of the defaults directly before it.
double noise_of_seconds(std::span<const ScanCosts> scans);
double noise_of_frames(std::span<const ScanCosts> scans);

}  // namespace vantage
