#pragma once
#include <filesystem>

namespace vantage {

/// The folder "vantage" in the folder that a variable such as XDG_CACHE_HOME names (XDG Base Directory
/// Specification). If the variable is not set, the folder is in HOME/`below_home` instead, such as
/// HOME/.cache. Empty if HOME is not set either.
std::filesystem::path xdg_folder(const char* variable, const char* below_home);

}  // namespace vantage
