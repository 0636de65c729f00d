#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"
#include "tests/bench/scenes/scene.h"

namespace vantage::bench {

/// Measurements that belong together: what one is compared with is timed in the same minute. What a run was
/// cut off in is done again.
struct Job {
    std::string name;  ///< unique in a scene's sweep
    std::function<std::vector<Measurement>()> run;
};

/// What is plotted over what.
struct Plot {
    const char* x;  ///< metric
    const char* y;
    bool log_x = true, log_y = false;
};

/// A knob, or several that hang together.
struct Sweep {
    const char* name;
    const char* title;
    const char* question;   ///< what a reader learns from it
    const char* truth;      ///< what it is measured against
    const char* precision;  ///< to what its exact end reproduces that
    std::vector<Plot> plots;
    /// The jobs on a scene; none where the scene does not have what is swept. `folder` takes exhibits.
    std::vector<Job> (*jobs)(const BenchScene& scene, const Effort& effort,
                             const std::filesystem::path& folder);
    bool apart = false;  ///< curves are knobs of their own, and are not compared with each other
};
std::span<const Sweep> sweeps();

}  // namespace vantage::bench
