#include "base/files/xdg_folder.h"

#include <cstdlib>

namespace vantage {

std::filesystem::path xdg_folder(const char* variable, const char* below_home) {
    if (const char* base = std::getenv(variable); base && *base)
        return std::filesystem::path(base) / "vantage";
    const char* home = std::getenv("HOME");
    return home && *home ? std::filesystem::path(home) / below_home / "vantage" : std::filesystem::path();
}

}  // namespace vantage
