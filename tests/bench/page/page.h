#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "tests/bench/results/tables.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {

struct PageInput {
    std::string title;
    std::span<const Sweep> sweeps;  ///< in the page's order; one named "presets" has a section of its own
    Run now;
    std::optional<Run> before;  ///< an earlier run, to show what has moved
};

/// Writes folder/index.html, one file with all plots and exhibits in it. Exhibits are read from `folder`; one
/// that is not there is said to be missing. Throws Error(input) where gnuplot is missing or fails,
/// Error(storage), std::out_of_range for a plot of something that is no metric.
void write_page(const std::filesystem::path& folder, const PageInput& input);

}  // namespace vantage::bench
