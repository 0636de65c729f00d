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
    std::span<const Sweep> sweeps;  ///< in the order of the page
    Run now;
    std::optional<Run> before;  ///< an earlier run to compare with
};

/// Writes folder/index.html, a single file that contains all plots and exhibits, and saves the plots in
/// folder/plots. Exhibits are read from `folder`; missing exhibits are marked as missing. Throws Error(input)
/// if gnuplot is missing or fails, Error(storage) if a file cannot be written, and std::out_of_range if a
/// plot has an unknown metric.
void write_page(const std::filesystem::path& folder, const PageInput& input);

}  // namespace vantage::bench
