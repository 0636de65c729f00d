#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// Runs a program, found in the PATH unless its name has a slash, without a shell. Its standard input is
/// empty, and its output goes to files; `out` and `err` may be the same. Returns the program's exit status,
/// -1 if a signal ended the program, or 127 if the program cannot be started.
int run_child(const std::vector<std::string>& words, const std::filesystem::path& out,
              const std::filesystem::path& err);

}  // namespace vantage
