#pragma once
#include <string>
#include <vector>

#include "player/options/shown/package_options.h"
#include "scene/story/scene_file.h"

namespace vantage {

class Command;

/// What is shown with the package.
struct ObjectOptions {
    std::vector<std::string> added;  ///< packages
};
void add_object_options(const Command& command, ObjectOptions& options);

/// The objects of the scene that the command line names: those of a scene file in place of the package, or
/// the package; then those that are added. Throws Error(input).
std::vector<SceneObject> named_objects(const PackageOptions& package, const ObjectOptions& options);

}  // namespace vantage
