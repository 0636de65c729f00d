#include "base/files/xdg_folder.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace vantage {

std::filesystem::path xdg_folder(const char* variable, const char* below_home) {
    if (const char* base = std::getenv(variable); base && *base)
        return std::filesystem::path(base) / "vantage";
    const char* home = std::getenv("HOME");
    return home && *home ? std::filesystem::path(home) / below_home / "vantage" : std::filesystem::path();
}

std::filesystem::path pictures_folder() {
    const char* home = std::getenv("HOME");
    if (!home || !*home) return {};
    const std::string begin = "XDG_PICTURES_DIR=\"", in_home = "$HOME/";
    std::ifstream folders(xdg_folder("XDG_CONFIG_HOME", ".config").replace_filename("user-dirs.dirs"));
    for (std::string line; std::getline(folders, line);) {
        if (!line.starts_with(begin)) continue;
        const std::string folder = line.substr(begin.size(), line.rfind('"') - begin.size());
        if (folder.starts_with(in_home)) return std::filesystem::path(home) / folder.substr(in_home.size());
        if (folder.starts_with('/')) return folder;
    }
    return std::filesystem::path(home) / "Pictures";
}

}  // namespace vantage
