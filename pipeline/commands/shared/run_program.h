#pragma once

namespace vantage {

/// The program `vantage`: does what the command line says, tells errors on stderr, and returns the exit code.
int run_program(int argc, char** argv);

}  // namespace vantage
