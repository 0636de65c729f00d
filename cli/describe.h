#pragma once
#include <CLI/CLI.hpp>

namespace vantage {

/// If the command line is `PROGRAM --describe`, which --help does not list, prints the description of `app`
/// as one line (manual/described_command.h), of which the build makes the manual and the completion of
/// shells. Returns whether it did.
bool describe_if_asked(const CLI::App& app, int argc, char** argv);

}  // namespace vantage
