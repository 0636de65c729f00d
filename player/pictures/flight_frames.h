#pragma once
#include <filesystem>
#include <vector>

#include "player/options/show_options.h"
#include "player/view/navigation.h"
#include "player/view/shots.h"
#include "scene/package/package_reader.h"
#include "scene/story/story.h"

namespace vantage {

/// The story next to the package or scene file; empty if there is none. Throws Error(input).
Story story_beside(const std::filesystem::path& package);

/// The cameras of a video's frames, which have this size, according to the options. Throws Error(usage) for
/// conflicting paths, a tour that is not in the story, or more than a million frames, and Error(input) for a
/// path or a story that cannot be read.
std::vector<Navigation> flight_frames(const PackageReader& package, const ShowOptions& options,
                                      const Story& story, FrameSize size);

}  // namespace vantage
