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
    CLI::App* c = app.add_subcommand(
        "extract", "Write a package's photos, cameras, masks, depth, mesh and points as ordinary files");
    c->footer(
        "Examples:\n  vantage extract chapel.vantage -o chapel-files\n"
        "  vantage extract chapel.vantage -o chapel-files --photo 0003\n"
        "In the folder: photos/ without lens distortion; sparse/, their cameras as COLMAP text, in the "
        "input's\n"
        "coordinates and with the poses as corrected; masks/ (RGBA: angle, depth, border, consensus); "
        "depth/\n"
        "(EXR, along the optical axis); mesh.ply and points.ply. COLMAP, or vantage prepare, reads the "
        "folder.");
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
