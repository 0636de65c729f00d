#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "pipeline/costs/costs.h"

namespace vantage {

/// How much measure_costs() measures.
struct CostEffort {
    double minutes = 3;  ///< time for the most important trials; infinite: all trials
    bool full = false;   ///< all trials and more held-out photos; every duration is measured three times
};

/// Progress and control of a measurement.
struct CostRun {
    std::function<void(const std::string& line)> report;  ///< before each step
    std::function<void(const ScanCosts& so_far)> save;    ///< after each trial
    const std::atomic<bool>* stop = nullptr;  ///< when set, the measurement throws Error(interrupted)
};

/// Measures the trials on a scan (a folder) or a package, except for those in `before`, the result of an
/// interrupted measurement of the same input with the same version. Photos are held out of the preparation of
/// a scan; with a package, they are excluded from blending. `work`: folder for packages and pictures. Throws
/// Error; Error(input) if fewer than four photos are usable.
ScanCosts measure_costs(const std::string& input, const CostEffort& effort, const std::filesystem::path& work,
                        ScanCosts before, const CostRun& run);

}  // namespace vantage
