// Reads settings of a command and specifications of synthetic scenes, both in TOML. Checks that accepted
// numbers are within their bounds.
#include <cstdlib>

#include "base/text/error.h"
#include "pipeline/commands/shared/apply_config.h"
#include "pipeline/run/config_files.h"
#include "pipeline/synth/spec.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

namespace {

struct ReadSettings {
    Command command{"fuzzed", ""};
    double width = 1;
    int threads = 1;
    bool trim = false;
    std::vector<std::string> names;
    ReadSettings() {
        command.real("--width", width, 1, 4096, "");
        command.integer("--threads", threads, 0, 64, "");
        command.flag("--trim", trim, "");
        command.list("--names", names, "").commas();
    }
};

}  // namespace

FUZZ_TARGET(config)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    folder.set("a.toml", fuzz::text_of(data, size));
    const std::filesystem::path file = folder.path() / "a.toml";
    try {
        ReadSettings s;
        apply_config(s.command, file.string());
        if (!(s.width >= 1 && s.width <= 4096) || s.threads < 0 || s.threads > 64) std::abort();
    } catch (const Error&) {
    }
    try {
        const SynthSpec s = read_spec(file);
        if (!(s.photos.fov >= 1 && s.photos.fov <= 150)) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
