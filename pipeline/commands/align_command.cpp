#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/text/error.h"
#include "pipeline/align/alignment.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/input_options.h"
#include "pipeline/input/input_paths.h"
#include "pipeline/input/read_scene.h"
#include "scene/package/output_file.h"
#include "scene/story/scene_file.h"

namespace vantage {
namespace {

struct AlignOptions {
    InputOptions input;
    std::string out;
    bool force = false;
};

void print(const Alignment& a) {
    fmt::print(text_output(),
               "features {} shared by photos, {} of them on the mesh (median error {:.1f} px)\n", a.features,
               a.on_mesh, a.median);
    fmt::print(text_output(), "agree    {:.2f} on a scale from 0 to 1; next best alignment {:.2f}\n",
               a.agreement, a.next);
    const Similarity& s = a.mesh_from_cameras;
    const Eigen::Matrix<double, 3, 4> m = matrix_of(s);
    for (int row = 0; row < 3; ++row)
        results()["matrix"].push_back({m(row, 0), m(row, 1), m(row, 2), m(row, 3)});
    results().update({{"features", a.features},
                      {"features_on_mesh", a.on_mesh},
                      {"median_px", a.median},
                      {"agreement", a.agreement},
                      {"next_agreement", a.next},
                      {"scale", s.scale},
                      {"error_px", a.pixels},
                      {"error_degrees", a.degrees},
                      {"error_move", a.move}});
    fmt::print(text_output(), "scale    {:.8g} mesh units per camera unit, within {:.2g} %\n", s.scale,
               100 * a.scale);
    fmt::print(text_output(),
               "error    {:.2f} px in the photos: {:.2g} degrees, {:.2g} mesh units (standard errors)\n",
               a.pixels, a.degrees, a.move);
}

int run_align(const AlignOptions& o) {
    if (!is_scene_file(o.out)) throw Error(Exit::usage, o.out + ": expected a name that ends in .toml");
    if (is_scene_file(o.input.input))
        throw Error(Exit::usage, o.input.input + ": expected the folder of one scan, found a scene file");
    const FoundInput found = find_input(o.input, {});
    if (found.lacks) throw *found.lacks;
    const InputFiles& files = found.files;
    if (files.mesh.empty() || files.cameras.empty())
        throw Error(Exit::usage, "align: expected a mesh, cameras and photos");
    const std::filesystem::path out =
        output_file(o.out, Product::scene, Inputs{input_paths(files), {}}, o.force);
    const SceneInput scene = read_scene(files);
    fmt::print(text_output(), "mesh     {}\ncameras  {} ({})\nphotos   {} ({})\n", files.mesh.string(),
               files.cameras.string(), scene.camera_format, files.photos.string(), scene.photos.size());
    std::fflush(text_output());
    const Alignment a = align(scene);
    print(a);
    SceneObject object;
    object.name = out.stem().string();
    object.input = {{}, files.mesh, files.cameras, files.photos, files.points, a.mesh_from_cameras};
    write_scene_file(out, {object});
    fmt::print(text_output(), "scene    {}\n", out.string());
    results()["scene"] = out.string();
    return int(Exit::ok);
}

}  // namespace

void add_align(const Command& program) {
    auto o = std::make_shared<AlignOptions>();
    const Command c =
        program.verb("align", "Find the pose of a mesh whose frame differs from that of its cameras");
    c.notes(
        "Features that photos share are triangulated and fitted to the mesh, with rotation, translation and "
        "scale.\n"
        "The resulting similarity transform is written to the scene file. The command fails if the photos do "
        "not determine it.\n"
        "Examples:\n  vantage align scans/chapel -o chapel.toml\n"
        "  vantage prepare chapel.toml -o chapel\n"
        "  vantage align --mesh laser.ply --cameras sparse --photos images -o laser.toml");
    add_scan_options(c, o->input);
    c.file("-o,--output", o->out, "the scene file to write, NAME.toml").required();
    c.force(o->force);
    c.action([o] { return run_align(*o); });
}

}  // namespace vantage
