#pragma once
#include <string>

#include "base/cli/command.h"
#include "pipeline/input/discover.h"
#include "pipeline/run/settings.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// Where the command line says that an input is; point clouds and image sets are in PrepareSettings.
struct InputOptions {
    std::string input, mesh, cameras, photos;
};

/// Adds INPUT, --mesh, --cameras and --photos to a command for one scan. `more`: of the help of INPUT.
void add_scan_options(const Command& command, InputOptions& options, const std::string& more = {});
/// Adds these for scans and scene files, --points and --image-sets.
void add_input_options(const Command& command, InputOptions& options, PrepareSettings& settings);

/// The parts of the input, as given or found in the folder. If they are not enough, `lacks` is Error(usage),
/// or the error of search(). Throws Error(input) if the folder cannot be read, Error(usage) if nothing is
/// given.
FoundInput find_input(const InputOptions& options, const PrepareSettings& settings);

/// Whether INPUT is a scene file. Throws Error(usage) if its parts are given as well.
bool is_scene_of_objects(const InputOptions& options, const PrepareSettings& settings);

/// Replaces the options by what a scene file has for one of its objects.
void take_input(const SceneObject::Input& input, InputOptions& options, PrepareSettings& settings);

}  // namespace vantage
