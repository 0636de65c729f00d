#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace vantage {

/// Lists the values of an option in --help and in completion, and accepts any value: for options whose values
/// are checked later, with a better message, or that also take a file (whose type is then FILE).
inline CLI::Validator known_values(const std::vector<std::string>& values) {
    return {[](std::string&) { return std::string(); }, "{" + CLI::detail::join(values, ",") + "}"};
}

}  // namespace vantage
