#include "pipeline/commands/shared/input_options.h"

#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/meshes/read_mesh.h"

namespace vantage {

void add_scan_options(const Command& c, InputOptions& o, const std::string& more) {
    c.file("INPUT", o.input, "folder with a mesh, cameras and photos" + more);
    c.file("--mesh", o.mesh, std::string("mesh file: ") + mesh_format_names);
    c.file("--cameras", o.cameras, camera_format_names());
    c.file("--photos", o.photos, "folder of photos").type("FOLDER");
}

void add_input_options(const Command& c, InputOptions& o, PrepareSettings& settings) {
    add_scan_options(c, o, ", or with a point cloud; or a scene file, NAME.toml, that lists several inputs");
    c.list("--points", settings.points,
           "point cloud to show, alone or with a mesh in the same coordinates: PLY, LAS, OBJ, STL, OFF; may "
           "be repeated")
        .type("FILE");
    c.file(
         "--image-sets", settings.image_sets,
         "grouping into image sets, which are shown one at a time: auto (by folders named visible, infrared, "
         "uvf, raking, "
         "before, ...), folders (each folder is an image set), off, or a TOML file with the patterns of each "
         "image set, such "
         "as infrared = [\"ir/*\", \"*_nir.tif\"]")
        .suggests({"auto", "folders", "off"});
}

FoundInput find_input(const InputOptions& o, const PrepareSettings& settings) {
    InputFiles given{.mesh = o.mesh, .cameras = o.cameras, .photos = o.photos};
    given.image_sets = settings.image_sets;
    given.align = settings.align;
    given.points.assign(settings.points.begin(), settings.points.end());
    given.compared.assign(settings.deviation_from.begin(), settings.deviation_from.end());
    FoundInput found = o.input.empty() ? FoundInput{given, {}} : search(o.input, given);
    if (found.lacks) return found;
    const InputFiles& files = found.files;
    const bool photos = !files.cameras.empty() && !files.photos.empty(),
               neither = files.cameras.empty() && files.photos.empty();
    const Error incomplete(
        Exit::usage,
        "expected an INPUT folder, or --mesh, --cameras and --photos together, or --points in "
        "place of --mesh, alone or with --cameras and --photos");
    if (files.mesh.empty() && files.points.empty() && neither) throw incomplete;
    if (files.mesh.empty() ? files.points.empty() || !(photos || neither) : !photos)
        found.lacks = incomplete;
    else if (files.mesh.empty() && !files.compared.empty())
        found.lacks =
            Error(Exit::usage, "--deviation-from: there is no mesh whose deviation could be measured");
    return found;
}

bool is_scene_of_objects(const InputOptions& o, const PrepareSettings& settings) {
    if (!is_scene_file(o.input) || std::filesystem::is_directory(o.input)) return false;
    if (!o.mesh.empty() || !o.cameras.empty() || !o.photos.empty() || !settings.points.empty() ||
        !settings.deviation_from.empty())
        throw Error(Exit::usage, o.input + ": a scene file already names the inputs of its objects");
    return true;
}

void take_input(const SceneObject::Input& in, InputOptions& o, PrepareSettings& settings) {
    o = {in.folder.string(), in.mesh.string(), in.cameras.string(), in.photos.string()};
    for (const std::filesystem::path& cloud : in.points) settings.points.push_back(cloud.string());
    settings.align = in.align;
}

}  // namespace vantage
