// Scene files. Checks that accepted numbers are within their bounds and that what is written back is read as
// the same objects.
#include <cmath>
#include <cstdlib>

#include "objects/scene_file.h"
#include "scene/error.h"
#include "tests/fuzz/memory_file.h"

using namespace vantage;

namespace {

void check_objects(const std::vector<SceneObject>& objects) {
    if (objects.empty() || objects.front().placement != Placement{}) std::abort();
    for (const SceneObject& o : objects) {
        if (o.name.empty() || o.name.find('/') != std::string::npos) std::abort();
        if (!(o.opacity >= 0 && o.opacity <= 1) || !(o.placement.scale > 0)) std::abort();
        if (!o.placement.move.allFinite() || !rotation_of(o.placement).allFinite()) std::abort();
    }
}

bool same(const SceneObject& a, const SceneObject& b) {
    return a.name == b.name && a.placement == b.placement && a.shown == b.shown && a.opacity == b.opacity;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    folder.set("church.toml", fuzz::text_of(data, size));
    const std::filesystem::path file = folder.path() / "church.toml";
    try {
        check_objects(read_scene_file(file, SceneUse::prepare));
    } catch (const Error&) {
    }
    try {
        const std::vector<SceneObject> objects = read_scene_file(file, SceneUse::show);
        check_objects(objects);
        folder.set("again.toml", scene_file_text(objects, folder.path()));
        const std::vector<SceneObject> again = read_scene_file(folder.path() / "again.toml", SceneUse::show);
        if (again.size() != objects.size()) std::abort();
        for (std::size_t i = 0; i < again.size(); ++i)
            if (!same(again[i], objects[i])) std::abort();
    } catch (const Error& e) {
        if (std::string(e.what()).find("again.toml") != std::string::npos) std::abort();
    }
    return 0;
}
