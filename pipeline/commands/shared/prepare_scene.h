#pragma once
#include <filesystem>
#include <functional>

#include "scene/story/scene_file.h"

namespace vantage {

/// Prepares each object of a scene file into a package in `folder` that has the object's name. Then writes a
/// scene file into `folder` that has the name of `file` and lists the packages. `prepare_one` returns an exit
/// code: the first other than ok and incomplete ends the work and is returned; otherwise, the result is
/// incomplete if any object is incomplete, and ok if all are complete. Throws Error.
int prepare_scene(const std::filesystem::path& file, const std::filesystem::path& folder, bool force,
                  const std::function<int(const SceneObject& object)>& prepare_one);

}  // namespace vantage
