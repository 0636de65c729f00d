#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {
class Command;
}

namespace vantage::bench {

struct RunOptions {
    std::vector<std::string> inputs, only;
    std::string set = "short";
    std::filesystem::path folder = "accuracy", against, redraw;
    bool list = false;
};
/// `options` must outlive the command.
void add_run_options(const Command& command, RunOptions& options);

/// Runs the sweeps or resumes an interrupted run, and writes the page. Returns the exit code. Throws Error.
int run(const RunOptions& options);

}  // namespace vantage::bench
