#pragma once
#include <CLI/CLI.hpp>
#include <functional>

/// One file per subcommand: each adds its options to the command line and sets `run` when it is chosen.
namespace vantage {

using Run = std::function<int()>;
void add_prepare(CLI::App& app, Run& run);
void add_merge(CLI::App& app, Run& run);
void add_refine(CLI::App& app, Run& run);
void add_info(CLI::App& app, Run& run);
void add_check(CLI::App& app, Run& run);
void add_diff(CLI::App& app, Run& run);
void add_extract(CLI::App& app, Run& run);
void add_synth(CLI::App& app, Run& run);

}  // namespace vantage
