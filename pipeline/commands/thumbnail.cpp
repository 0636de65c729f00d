#include "pipeline/results/thumbnail.h"

#include "cli/force_option.h"
#include "output/output_file.h"
#include "output/package_inputs.h"
#include "output/png_file.h"
#include "pipeline/commands/commands.h"
#include "remote/remote_package.h"

namespace vantage {
namespace {

struct ThumbnailOptions {
    std::string file, out;
    int size = 256;
    bool force = false;
};

int run_thumbnail(const ThumbnailOptions& o) {
    const PackageReader package = open_package(o.file);
    const std::filesystem::path out = output_file(o.out, Product::png, inputs_of(package), o.force);
    const RgbaImage image = thumbnail(package, o.size);
    write_png(out, image.width, image.height, image.rgba);
    return 0;
}

}  // namespace

void add_thumbnail(CLI::App& app, Run& run) {
    auto o = std::make_shared<ThumbnailOptions>();
    CLI::App* c = app.add_subcommand("thumbnail", "Write a small picture of a package, for file managers");
    c->footer(
        "It shows the photo at which the player opens, at most as large as the thumbnail in the package.\n"
        "Example:\n  vantage thumbnail chapel.vantage -o chapel.png --size 512");
    c->add_option("FILE", o->file, "the package, or its URL")->type_name("PACKAGE")->required();
    c->add_option("-o,--output", o->out, "the PNG to write, whatever its extension")
        ->type_name("FILE")
        ->required();
    c->add_option("--size", o->size, "its long side in px, at most")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    add_force(*c, o->force);
    c->callback([o, &run] { run = [o] { return run_thumbnail(*o); }; });
}

}  // namespace vantage
