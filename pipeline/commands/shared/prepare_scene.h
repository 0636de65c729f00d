#pragma once
#include <filesystem>
#include <functional>

#include "scene/story/scene_file.h"

namespace vantage {

/// Prepares each object of a scene file with `prepare_one`, which returns an exit code, into a package of its
/// name in `folder`. There it also writes a scene file of the same name that lists the packages. Stops at the
/// first exit code other than ok and incomplete and returns it; else returns incomplete if any object is, or
/// ok. Throws Error.
int prepare_scene(const std::filesystem::path& file, const std::filesystem::path& folder, bool force,
                  const std::function<int(const SceneObject& object)>& prepare_one);

}  // namespace vantage
