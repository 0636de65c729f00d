#include "pipeline/run/config_files.h"

#include <optional>

#include "base/text/error.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> in_configs(const std::string& name) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& folder : {program / "../share/vantage/configs", fs::path(VANTAGE_CONFIGS)})
        if (fs::is_regular_file(folder / name)) return folder / name;
    return {};
}

}  // namespace

fs::path find_preset(const std::string& name) {
    if (fs::is_regular_file(name)) return name;
    if (const auto preset = in_configs(name + ".toml")) return *preset;
    std::string known;
    for (const char* preset : presets) known += (known.empty() ? "" : ", ") + std::string(preset);
    throw Error(Exit::usage, "--preset " + name + ": expected a TOML file or one of " + known);
}

}  // namespace vantage
