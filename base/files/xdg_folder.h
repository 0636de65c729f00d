#pragma once
#include <filesystem>

namespace vantage {

/// The folder "vantage" in the folder named by a variable such as XDG_CACHE_HOME, or else in
/// HOME/`below_home`, such as .cache (XDG Base Directory Specification). Empty if neither is set.
std::filesystem::path xdg_folder(const char* variable, const char* below_home);

}  // namespace vantage
