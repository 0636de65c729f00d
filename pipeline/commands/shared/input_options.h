#pragma once
#include <string>

#include "base/cli/command.h"
#include "pipeline/input/discover.h"
#include "pipeline/run/settings.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// The location of an input, as given on the command line; point clouds and image sets are in
/// PrepareSettings.
struct InputOptions {
    std::string input, mesh, cameras, photos;
};

/// Adds INPUT, --mesh, --cameras and --photos to a command for one scan. `more` is appended to the help of
/// INPUT.
void add_scan_options(const Command& command, InputOptions& options, const std::string& more = {});
/// Adds the options of add_scan_options() to a command for scans and scene files, and also --points and
/// --image-sets.
void add_input_options(const Command& command, InputOptions& options, PrepareSettings& settings);

/// The parts of the input, as given or found in the folder. If a part is missing, `lacks` is Error(usage), or
/// the error of search(). Throws Error(input) if the folder cannot be read, and Error(usage) if nothing is
/// given.
FoundInput find_input(const InputOptions& options, const PrepareSettings& settings);

/// Whether INPUT is a scene file. Throws Error(usage) if parts of the input are given as well.
bool is_scene_of_objects(const InputOptions& options, const PrepareSettings& settings);

/// Replaces the options with those of an object in a scene file.
void take_input(const SceneObject::Input& input, InputOptions& options, PrepareSettings& settings);

}  // namespace vantage
