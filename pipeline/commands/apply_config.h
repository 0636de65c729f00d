#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace vantage {

/// Gives `command` the settings of a TOML file: each key is the name of one of its long options, each value
/// what would stand on the command line (lists for options that take several). Options given there stay.
/// `name` is a file, or a preset of configs/ without its extension. Throws Error(usage) naming file and key.
void apply_config(CLI::App& command, const std::string& name);

}  // namespace vantage
