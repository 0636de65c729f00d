// Scene files. Checks that accepted numbers are within their bounds and that objects are unchanged after
// writing and reading.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "base/text/error.h"
#include "scene/story/scene_file.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

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

/// The objects in the file; empty if the file is rejected.
std::optional<std::vector<SceneObject>> accepted(const std::filesystem::path& file, SceneUse use) {
    try {
        return read_scene_file(file, use);
    } catch (const Error&) {
        return {};
    }
}

}  // namespace

FUZZ_TARGET(scene)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    folder.set("church.toml", fuzz::text_of(data, size));
    const std::filesystem::path file = folder.path() / "church.toml";
    if (const auto inputs = accepted(file, SceneUse::prepare)) check_objects(*inputs);
    const auto objects = accepted(file, SceneUse::show);
    if (!objects) return 0;
    check_objects(*objects);
    folder.set("again.toml", scene_file_text(*objects, folder.path()));
    const auto again = accepted(folder.path() / "again.toml", SceneUse::show);
    if (!again || !std::ranges::equal(*again, *objects, same)) std::abort();
    return 0;
}
