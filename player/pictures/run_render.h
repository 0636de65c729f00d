#pragma once
#include <vector>

#include "player/options/show_options.h"
#include "scene/package/package_reader.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// Renders the pictures given by the options, without a display. `objects`: the objects of the scene; the
/// first one is the package. Returns the exit code: damaged if a tile had a checksum mismatch and a coarser
/// tile was shown. Throws Error.
int run_render(const PackageReader& package, const ShowOptions& options,
               const std::vector<SceneObject>& objects);

}  // namespace vantage
