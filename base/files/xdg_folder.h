#pragma once
#include <filesystem>

namespace vantage {

/// The folder "vantage" in the folder that a variable such as XDG_CACHE_HOME names (XDG Base Directory
/// Specification). If the variable is not set, the folder is in HOME/`below_home` instead, such as
/// HOME/.cache. Empty if HOME is not set either.
std::filesystem::path xdg_folder(const char* variable, const char* below_home);

/// The user's folder of pictures: XDG_PICTURES_DIR in the file user-dirs.dirs of xdg-user-dirs, or
/// HOME/Pictures if that does not name one. Empty if HOME is not set.
std::filesystem::path pictures_folder();

}  // namespace vantage
