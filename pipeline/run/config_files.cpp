#include "pipeline/run/config_files.h"

#include <optional>

#include "base/text/error.h"

namespace vantage {

namespace fs = std::filesystem;

std::optional<fs::path> find_config(const std::string& name) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& folder : {program / "../share/vantage/configs", fs::path(VANTAGE_CONFIGS)})
        if (fs::is_regular_file(folder / name)) return folder / name;
    return {};
}

fs::path find_preset(const std::string& name) {
    if (fs::is_regular_file(name)) return name;
    if (const auto preset = find_config(name + ".toml")) return *preset;
    std::string known;
    for (const char* preset : presets) known += (known.empty() ? "" : ", ") + std::string(preset);
    throw Error(Exit::usage, "--preset " + name + ": expected a TOML file or one of " + known);
}

}  // namespace vantage
