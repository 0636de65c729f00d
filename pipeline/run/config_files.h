#pragma once
#include <array>
#include <filesystem>
#include <string>

namespace vantage {

/// The names of the presets in configs/.
inline constexpr std::array presets{"preview", "default", "ci"};

/// The file `name` if it exists, else the preset configs/NAME.toml, either installed with the program
/// (../share/vantage/configs) or in the source tree. Throws Error(usage) if there is none.
std::filesystem::path find_preset(const std::string& name);

}  // namespace vantage
