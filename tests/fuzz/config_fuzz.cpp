// A command's settings and the specification of a synthetic scene, both TOML. Checks that accepted numbers
// are within their bounds.
#include <cstdlib>

#include "cli/real_range.h"
#include "pipeline/commands/apply_config.h"
#include "pipeline/settings/config_files.h"
#include "pipeline/synth/spec.h"
#include "scene/error.h"
#include "tests/fuzz/memory_file.h"

using namespace vantage;

namespace {

struct Command {
    CLI::App app;
    double width = 1;
    int threads = 1;
    bool trim = false;
    std::vector<std::string> names;
    Command() {
        app.add_option("--width", width)->check(real_range(1, 4096));
        app.add_option("--threads", threads)->check(CLI::Range(0, 64));
        app.add_flag("--trim", trim);
        app.add_option("--names", names)->delimiter(',');
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    folder.set("a.toml", fuzz::text_of(data, size));
    const std::filesystem::path file = folder.path() / "a.toml";
    try {
        Command c;
        apply_config(c.app, file.string());
        if (!(c.width >= 1 && c.width <= 4096) || c.threads < 0 || c.threads > 64) std::abort();
    } catch (const Error&) {
    }
    try {
        const SynthSpec s = read_spec(file);
        if (!(s.photos.fov >= 1 && s.photos.fov <= 150)) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
