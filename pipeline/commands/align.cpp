#include <fmt/format.h>

#include <cmath>

#include "cli/force_option.h"
#include "objects/scene_file.h"
#include "output/output_file.h"
#include "pipeline/align/alignment.h"
#include "pipeline/commands/commands.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/input_paths.h"
#include "pipeline/input/read_scene.h"
#include "scene/error.h"

namespace vantage {
namespace {

struct AlignOptions {
    std::string input, mesh, cameras, photos, out;
    unsigned threads = 0;
    bool force = false;
};

InputFiles input_files(const AlignOptions& o) {
    InputFiles files{.mesh = o.mesh, .cameras = o.cameras, .photos = o.photos};
    if (!o.input.empty()) files = discover(o.input, files);
    if (files.mesh.empty() || files.cameras.empty() || files.photos.empty())
        throw Error(
            Exit::usage,
            "align: expected a folder with a mesh, cameras and photos, or --mesh, --cameras and --photos");
    return files;
}

void print(const Alignment& a) {
    fmt::print("features {} that photos share, {} of them on the mesh, to {:.1f} px (median)\n", a.features,
               a.on_mesh, a.median);
    fmt::print("agree    {:.2f} of 1; the next best alignment {:.2f}\n", a.agreement, a.next);
    const Similarity& s = a.mesh_from_cameras;
    fmt::print("scale    {:.8g} mesh units per camera unit, within {:.2g} %\n", s.scale, 100 * a.scale);
    fmt::print("certain  to {:.2f} px in the photos: {:.2g} degrees, {:.2g} mesh units (standard errors)\n",
               a.pixels, a.degrees, a.move);
}

int run_align(const AlignOptions& o) {
    const InputFiles files = input_files(o);
    const std::filesystem::path out =
        output_file(o.out, Product::scene, Inputs{input_paths(files), {}}, o.force);
    const SceneInput scene = read_scene(files);
    fmt::print("mesh     {}\ncameras  {} ({})\nphotos   {} ({})\n", files.mesh.string(),
               files.cameras.string(), scene.camera_format, files.photos.string(), scene.photos.size());
    std::fflush(stdout);
    const Alignment a = align(scene, o.threads);
    print(a);
    SceneObject object;
    object.name = out.stem().string();
    object.input = {{}, files.mesh, files.cameras, files.photos, files.points, a.mesh_from_cameras};
    write_scene_file(out, {object});
    fmt::print("scene    {}\n", out.string());
    return int(Exit::ok);
}

}  // namespace

void add_align(CLI::App& app, Run& run) {
    auto o = std::make_shared<AlignOptions>();
    CLI::App* c =
        app.add_subcommand("align", "Find where a mesh belongs that is in another frame than its cameras");
    c->footer(
        "Features that photos share are triangulated and fitted to the mesh, with rotation, translation and "
        "scale.\n"
        "The scene file holds the similarity; it is refused where photos do not settle it.\n"
        "Examples:\n  vantage align scans/chapel -o chapel.toml\n"
        "  vantage prepare chapel.toml -o chapel\n"
        "  vantage align --mesh laser.ply --cameras sparse --photos images -o laser.toml");
    c->add_option("INPUT", o->input, "folder with a mesh, cameras and photos")->type_name("FOLDER");
    c->add_option("--mesh", o->mesh, "mesh file: PLY, OBJ, STL, OFF")->type_name("FILE");
    c->add_option("--cameras", o->cameras, camera_format_names())->type_name("FILE");
    c->add_option("--photos", o->photos, "folder of photos")->type_name("FOLDER");
    c->add_option("-o,--output", o->out, "the scene file to write, NAME.toml")->type_name("FILE")->required();
    c->add_option("--threads", o->threads, "threads (default: all cores)");
    add_force(*c, o->force);
    c->callback([o, &run] {
        if (!is_scene_file(o->out)) throw Error(Exit::usage, o->out + ": expected a name that ends in .toml");
        run = [o] { return run_align(*o); };
    });
}

}  // namespace vantage
