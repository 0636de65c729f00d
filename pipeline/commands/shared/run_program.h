#pragma once

namespace vantage {

/// The program `vantage`: runs the command line, prints errors to stderr, and returns the exit code.
int run_program(int argc, char** argv);

}  // namespace vantage
