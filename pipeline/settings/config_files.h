#pragma once
#include <array>
#include <filesystem>
#include <string>

namespace vantage {

/// A file of configs/, either installed with the program (../share/vantage/configs) or in the source tree.
/// Throws Error(usage) if neither has it.
std::filesystem::path find_config_file(const std::string& name);

/// The names of the presets in configs/.
inline constexpr std::array presets{"preview", "default", "overnight", "ci"};

/// The file `name` if it exists, else the preset configs/NAME.toml. Throws Error(usage) if neither exists.
std::filesystem::path find_preset(const std::string& name);

}  // namespace vantage
