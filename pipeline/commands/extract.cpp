#include "pipeline/results/extract.h"

#include "cli/force_option.h"
#include "pipeline/commands/commands.h"

namespace vantage {
namespace {

struct ExtractOptions {
    std::string file, out;
    std::vector<std::string> photos;
    bool force = false;
};

}  // namespace

void add_extract(CLI::App& app, Run& run) {
    auto o = std::make_shared<ExtractOptions>();
    CLI::App* c =
        app.add_subcommand("extract", "Write a package's photos, masks, depth and mesh as ordinary files");
    c->footer("Example:\n  vantage extract chapel.vantage -o chapel-files --photo 0003");
    c->add_option("FILE", o->file, "the package")->type_name("PACKAGE")->required();
    c->add_option("-o,--output", o->out, "folder to write into")->type_name("FOLDER")->required();
    c->add_option("--photo", o->photos, "only these photos")->type_name("PHOTO")->delimiter(',');
    add_force(*c, o->force);
    c->callback([o, &run] {
        run = [o] {
            extract(o->file, o->out, o->photos, o->force);
            return 0;
        };
    });
}

}  // namespace vantage
