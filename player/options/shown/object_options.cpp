#include "player/options/shown/object_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_object_options(const Command& c, ObjectOptions& o) {
    c.list("--add", o.added,
           "also show this package, in the same coordinates; a scene file (NAME.toml, in place of the "
           "package) also moves, turns, scales and fades objects")
        .type("PACKAGE")
        .commas();
}

std::vector<SceneObject> named_objects(const PackageOptions& package, const ObjectOptions& o) {
    const auto object = [](const std::filesystem::path& file) {
        return SceneObject{file.stem().string(), file, {}, true};
    };
    std::vector<SceneObject> out = is_scene_file(package.file) ? read_scene_file(package.file, SceneUse::show)
                                                               : std::vector{object(package.file)};
    for (const std::string& added : o.added) out.push_back(object(added));
    return out;
}

}  // namespace vantage
