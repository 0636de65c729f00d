#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/files/png_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/reports/thumbnail.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"
#include "scene/remote/remote_package.h"

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
    fmt::print(text_output(), "{}  {}x{}\n", out.string(), image.width, image.height);
    results().update({{"file", out.string()}, {"width", image.width}, {"height", image.height}});
    return 0;
}

}  // namespace

void add_thumbnail(const Command& program) {
    auto o = std::make_shared<ThumbnailOptions>();
    const Command c = program.verb("thumbnail", "Write a small picture of a package, for file managers");
    c.notes(
        "The picture shows the photo whose view the player opens with, and is never larger than the "
        "thumbnail in the package.\n"
        "Example:\n  vantage thumbnail chapel.vantage -o chapel.png --size 512");
    c.file("FILE", o->file, "the package, or its URL").type("PACKAGE").required();
    c.file("-o,--output", o->out, "the PNG file to write, whatever its extension").required();
    c.integer("--size", o->size, 1, 4096, "maximum long side in px");
    c.force(o->force);
    c.action([o] { return run_thumbnail(*o); });
}

}  // namespace vantage
