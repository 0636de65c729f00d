#include "pipeline/commands/shared/prepare_scene.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/cli/standard_output.h"
#include "base/files/make_folder.h"
#include "base/text/error.h"
#include "scene/package/output_file.h"

namespace vantage {

int prepare_scene(const std::filesystem::path& file, const std::filesystem::path& folder, bool force,
                  const std::function<int(const SceneObject& object)>& prepare_one) {
    std::vector<SceneObject> objects = read_scene_file(file, SceneUse::prepare);
    make_folder(folder);
    const std::filesystem::path list =
        output_file(folder / file.filename(), Product::scene, {{file}, {}}, force);
    int worst = int(Exit::ok);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        SceneObject& object = objects[i];
        object.package = folder / (object.name + ".vantage");
        fmt::print(text_output(), "object   {} ({} of {})\n", object.name, i + 1, objects.size());
        std::fflush(text_output());
        const nlohmann::json of_scene = results();
        const int code = prepare_one(object);
        nlohmann::json of_object = std::exchange(results(), of_scene);
        of_object["name"] = object.name;
        for (const auto& [key, value] : of_scene.items()) of_object.erase(key);
        results()["objects"].push_back(std::move(of_object));
        if (code != int(Exit::ok) && code != int(Exit::incomplete)) return code;
        if (code != int(Exit::ok)) worst = code;
    }
    write_scene_file(list, objects);
    fmt::print(text_output(), "scene    {}\n", list.string());
    results()["scene"] = list.string();
    return worst;
}

}  // namespace vantage
