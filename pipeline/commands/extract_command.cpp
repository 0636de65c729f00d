#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/text/error.h"
#include "pipeline/commands/commands.h"
#include "pipeline/reports/extract.h"

namespace vantage {
namespace {

struct ExtractOptions {
    std::string file, out;
    std::vector<std::string> photos;
    bool undistorted = false, force = false;
};

}  // namespace

void add_extract(const Command& program) {
    auto o = std::make_shared<ExtractOptions>();
    const Command c = program.verb(
        "extract",
        "Write a package's photos, cameras, weight maps, depth, mesh and points as ordinary files");
    c.notes(
        "Examples:\n  vantage extract chapel.vantage -o chapel-files\n"
        "  vantage extract chapel.vantage -o chapel-files --photo 0003\n"
        "In the folder: photos/ as they were taken; sparse/, their cameras and lenses as COLMAP text, in "
        "the\n"
        "input's coordinates and with the poses as corrected; weights/ (RGBA: angle, depth, border, "
        "transient masking) and\n"
        "depth/ (EXR, along the optical axis), without lens distortion; mesh.ply and points.ply. COLMAP, "
        "or\n"
        "vantage prepare, reads the folder.");
    c.file("FILE", o->file, "the package").type("PACKAGE").required();
    c.file("-o,--output", o->out, "folder to write into").type("FOLDER").required();
    c.list("--photo", o->photos, "only these photos").type("PHOTO").commas();
    c.flag("--undistorted", o->undistorted, "photos without lens distortion");
    c.force(o->force);
    c.action([o] {
        extract(o->file, o->out, o->photos, o->undistorted, o->force);
        fmt::print(text_output(), "files    {}\n", o->out);
        results()["folder"] = o->out;
        return int(Exit::ok);
    });
}

}  // namespace vantage
