#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace vantage::bench {

struct RunOptions {
    std::vector<std::string> inputs, only;
    std::string set = "short";
    std::filesystem::path folder = "accuracy", against, redraw;
    bool list = false;
};
void add_run_options(CLI::App& app, RunOptions& options);

/// Runs the sweeps, resuming an interrupted run, and writes the page. Returns the exit code. Throws Error.
int run(const RunOptions& options);

}  // namespace vantage::bench
