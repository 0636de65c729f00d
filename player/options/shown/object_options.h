#pragma once
#include <string>
#include <vector>

#include "player/options/shown/package_options.h"
#include "scene/story/scene_file.h"

namespace vantage {

class Command;

/// Objects shown in addition to the package.
struct ObjectOptions {
    std::vector<std::string> added;  ///< packages
};
void add_object_options(const Command& command, ObjectOptions& options);

/// The scene's objects from the command line: those of a scene file given as the package, or the package
/// itself, followed by the added objects. Throws Error(input).
std::vector<SceneObject> named_objects(const PackageOptions& package, const ObjectOptions& options);

}  // namespace vantage
