#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// A file of configs/, beside the program or in the sources. Throws Error(usage) where there is none of that
/// name.
std::filesystem::path find_config_file(const std::string& name);

/// A TOML file of this name, or the preset NAME.toml of configs/. Throws Error(usage) if there is neither.
std::filesystem::path find_preset(const std::string& name);

}  // namespace vantage
