#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace vantage {

/// The names of the presets in configs/.
inline constexpr std::array presets{"preview", "default", "ci"};

/// The file configs/`name`, either installed with the program (../share/vantage/configs) or in the source
/// tree.
std::optional<std::filesystem::path> find_config(const std::string& name);

/// The file `name` if it exists, otherwise the preset configs/NAME.toml. Throws Error(usage) if there is
/// no such preset.
std::filesystem::path find_preset(const std::string& name);

}  // namespace vantage
