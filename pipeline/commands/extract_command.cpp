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

void print(const Extracted& e, const std::string& folder) {
    if (e.photos)
        fmt::print(text_output(), "photos   {}/photos ({}), with their cameras in sparse\n", folder,
                   e.photos);
    if (e.triangles)
        fmt::print(text_output(),
                   "mesh     {}/mesh.ply ({} vertices, {} triangles: as prepared, with the input's large "
                   "triangles divided)\n",
                   folder, e.vertices, e.triangles);
    if (e.points) fmt::print(text_output(), "points   {}/points.ply ({})\n", folder, e.points);
    results().update({{"folder", folder},
                      {"photos", e.photos},
                      {"vertices", e.vertices},
                      {"triangles", e.triangles},
                      {"points", e.points}});
}

}  // namespace

void add_extract(const Command& program) {
    auto o = std::make_shared<ExtractOptions>();
    const Command c = program.verb(
        "extract",
        "Write a package's photos, cameras, weight maps, depth, mesh and points as ordinary files");
    c.notes(
        "Examples:\n  vantage extract chapel.vantage -o chapel-files\n"
        "  vantage extract chapel.vantage -o chapel-files --photo 0003\n"
        "The folder contains photos/, as they were taken; sparse/, their cameras and lenses as COLMAP text, "
        "in the\n"
        "input's coordinates and with the corrected poses; weights/ (RGBA: angle, depth, border, transient "
        "masking) and\n"
        "depth/ (EXR, along the optical axis), both without lens distortion; mesh.ply and points.ply.\n"
        "The mesh is that of the package: triangles with edges longer than 1/64 of the model's diagonal have "
        "been\n"
        "divided, which does not change the surface. COLMAP and 'vantage prepare' can read the folder.");
    c.file("FILE", o->file, "the package").type("PACKAGE").required();
    c.file("-o,--output", o->out, "folder to write into").type("FOLDER").required();
    c.list("--photo", o->photos, "only these photos").type("PHOTO").commas();
    c.flag("--undistorted", o->undistorted, "photos without lens distortion");
    c.force(o->force);
    c.action([o] {
        print(extract(o->file, o->out, o->photos, o->undistorted, o->force), o->out);
        return int(Exit::ok);
    });
}

}  // namespace vantage
