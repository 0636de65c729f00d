#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "player/options/show_options.h"
#include "player/options/shown/opened_package.h"
#include "player/verbs/verbs.h"
#include "scene/package/contents/image_sets.h"

namespace vantage {
namespace {

void list_photos(const PackageReader& package) {
    const std::vector<ImageSet> image_sets = read_image_sets(package);
    results()["photos"] = nlohmann::json::array();
    for (const package::PhotoRecord& p : package.photos()) {
        const std::string& set = image_sets[p.image_set].name;
        const bool held_out = p.flags & package::photo_held_out;
        std::fprintf(text_output(), "%s  %s%s%ux%u  sees %.1f %% of the vertices%s\n", p.name, set.c_str(),
                     image_sets.size() > 1 ? "  " : "", p.width, p.height, 100 * p.visible_vertices,
                     held_out ? "  held out" : "");
        results()["photos"].push_back({{"name", p.name},
                                       {"image_set", set},
                                       {"width", p.width},
                                       {"height", p.height},
                                       {"visible_vertices", p.visible_vertices},
                                       {"held_out", held_out}});
    }
}

}  // namespace

void add_list(const Command& program) {
    struct ListOptions {
        PackageOptions package;
        MemoryOptions memory;
    };
    const auto o = std::make_shared<ListOptions>();
    const Command c = program.verb("list", "List the photos of a package");
    add_package_argument(c, o->package).required();
    c.notes(
        "Examples:\n"
        "  vantage-player list chapel.vantage\n"
        "  vantage-player list https://museum.org/chapel.vantage --json");
    c.action([o] {
        const std::vector<SceneObject> objects = named_objects(o->package, {});
        const PackageReader package = opened_package(objects.front().package, o->memory);
        package.meta();  // not needed for the list, but reports damage
        list_photos(package);
        return int(Exit::ok);
    });
}

}  // namespace vantage
