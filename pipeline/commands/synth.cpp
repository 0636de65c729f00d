#include <fmt/format.h>

#include <mutex>

#include "cli/force_option.h"
#include "output/output_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/progress_line.h"
#include "pipeline/synth/synthesize.h"

namespace vantage {

void add_synth(CLI::App& app, Run& run) {
    struct SynthOptions {
        std::string spec, out;
        bool force = false;
    };
    auto o = std::make_shared<SynthOptions>();
    CLI::App* c = app.add_subcommand(
        "synth", "Generate a synthetic scene with known ground truth from a specification");
    c->footer("Example:\n  vantage synth data/demo.toml -o demo-scene");
    c->add_option("SPEC", o->spec, "TOML specification, such as those in data/")
        ->type_name("FILE")
        ->required();
    c->add_option("-o,--output", o->out, "folder to write into")->type_name("FOLDER")->required();
    add_force(*c, o->force);
    c->callback([o, &run] {
        run = [o] {
            {
                const SynthSpec spec = read_spec(o->spec);
                expect_result_folder(o->out, synth_mark, Product::csv, synthesized_files(spec),
                                     {{o->spec}, {}}, o->force);
                std::mutex mutex;
                const ProgressStyle style = progress_style("auto");
                ProgressLine line(style);
                synthesize(spec, o->out, [&](std::size_t done, std::size_t total) {
                    const std::scoped_lock lock(mutex);
                    // In a log, a line per tenth is enough.
                    if (style == ProgressStyle::bar || done * 10 / total > (done - 1) * 10 / total)
                        line.show({"photos", "", done, total});
                });
            }
            fmt::print("scene    {}\n", o->out);
            return 0;
        };
    });
}

}  // namespace vantage
