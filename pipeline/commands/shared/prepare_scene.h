#pragma once
#include <filesystem>
#include <functional>

#include "scene/story/scene_file.h"

namespace vantage {

/// Prepares each object of a scene file with `prepare_one`, which returns an exit code, into a package with
/// the object's name in `folder`, and writes a scene file with the same name as `file` there that lists the
/// packages. Stops at the first exit code other than ok and incomplete and returns it; otherwise returns
/// incomplete if any object is incomplete, else ok. Throws Error.
int prepare_scene(const std::filesystem::path& file, const std::filesystem::path& folder, bool force,
                  const std::function<int(const SceneObject& object)>& prepare_one);

}  // namespace vantage
