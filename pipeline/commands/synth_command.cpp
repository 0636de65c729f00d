#include <fmt/format.h>

#include <mutex>
#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/text/error.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/progress_option.h"
#include "pipeline/synth/synthesize.h"
#include "scene/package/output_file.h"

namespace vantage {

void add_synth(const Command& program) {
    struct SynthOptions {
        std::string spec, out;
        bool force = false;
    };
    auto o = std::make_shared<SynthOptions>();
    const Command c =
        program.verb("synth", "Generate a synthetic scene with known ground truth from a specification");
    c.notes("Example:\n  vantage synth data/demo.toml -o demo-scene");
    c.file("SPEC", o->spec, "TOML specification, such as those in data/").required();
    c.file("-o,--output", o->out, "folder to write into").type("FOLDER").required();
    c.force(o->force);
    c.action([o] {
        {
            const SynthSpec spec = read_spec(o->spec);
            expect_result_folder(o->out, synth_mark, Product::csv, synthesized_files(spec), {{o->spec}, {}},
                                 o->force);
            std::mutex mutex;
            ProgressLine line(ProgressStyle::automatic);
            synthesize(spec, o->out, [&](std::size_t done, std::size_t total) {
                const std::scoped_lock lock(mutex);
                // A log gets one line per tenth of the photos.
                if (line.style() == ProgressStyle::bar || done * 10 / total > (done - 1) * 10 / total)
                    line.show({"photos", "", done, total});
            });
        }
        fmt::print(text_output(), "scene    {}\n", o->out);
        results()["folder"] = o->out;
        return int(Exit::ok);
    });
}

}  // namespace vantage
