#pragma once
#include <filesystem>

namespace vantage {

/// The folder "vantage" in the one that a variable such as XDG_CACHE_HOME names, else in `below_home`, such
/// as .cache, of HOME (XDG Base Directory Specification). Empty if neither is set.
std::filesystem::path xdg_folder(const char* variable, const char* below_home);

}  // namespace vantage
