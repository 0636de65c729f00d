#pragma once
#include <CLI/CLI.hpp>
#include <optional>

namespace vantage {

/// Parses the command line. Returns an exit code if the program should exit: after --help, --describe or a
/// usage error.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

}  // namespace vantage
