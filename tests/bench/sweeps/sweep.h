#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"
#include "tests/bench/scenes/scene.h"

namespace vantage::bench {

/// Measurements that are made together, so that values that are compared are measured at about the same time.
/// An interrupted job starts over.
struct Job {
    std::string name;  ///< unique within a sweep on a scene
    std::function<std::vector<Measurement>()> run;
};

/// One metric plotted against another.
struct Plot {
    const char* x;  ///< metric
    const char* y;
    bool log_x = true, log_y = false;
};

/// The measurements for different values of one setting, or of several settings that interact.
struct Sweep {
    const char* name;
    const char* title;
    const char* question;   ///< the question that the sweep answers
    const char* truth;      ///< reference that errors are measured against
    const char* precision;  ///< how closely the exact setting reproduces the reference
    std::vector<Plot> plots;
    /// The jobs on a scene; empty if the sweep does not apply to it. Exhibits are written to `folder`.
    std::vector<Job> (*jobs)(const BenchScene& scene, const Effort& effort,
                             const std::filesystem::path& folder);
    bool apart = false;  ///< each curve is for a separate setting; curves are not compared with each other
};
std::span<const Sweep> sweeps();

}  // namespace vantage::bench
