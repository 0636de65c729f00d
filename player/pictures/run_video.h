#pragma once
#include <vector>

#include "player/options/show_options.h"
#include "scene/package/package_reader.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// Renders the video given by the options, without a display: to a file *.mp4 or *.webm, or as PNG files to a
/// folder. Every frame has all its tiles. `objects`: the objects of the scene; the first one is the package.
/// Returns the exit code: damaged if a tile had a checksum mismatch and a coarser tile was shown. Throws
/// Error. Throws Error(interrupted) after a signal; in this case, a folder keeps the frames written so far,
/// but no video file is written.
int run_video(const PackageReader& package, const ShowOptions& options,
              const std::vector<SceneObject>& objects);

}  // namespace vantage
