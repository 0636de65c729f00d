#pragma once
#include <filesystem>

#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"
#include "player/options/show_options.h"
#include "player/window/remembered.h"

namespace vantage {

/// Throws Error(damaged) if there is neither a photo nor a point, or META is damaged, which showing does not
/// need.
void expect_content(const PackageReader& package);

/// The settings of the command line, or those remembered in the folder, if there is one.
Remembered start_settings(const PackageReader& package, const ShowOptions& options,
                          const std::filesystem::path& folder);

/// The language of the command line, or the one chosen before, or the system's.
std::string chosen_language(const ShowOptions& options, const Remembered& remembered);

/// A session at the first photo of --photo, or the middle one; without photos, before the model.
Session start_session(const PackageReader& package, const ShowOptions& options, const Remembered& remembered,
                      WindowState& window);

/// Fits a session to the scene that is shown: the photos in use and their errors, and what the story says:
/// the first view, unless the command line gives one, and the background.
void begin_in_scene(Session& session, const PackageReader& package, const ActiveStory& active,
                    const ShowOptions& options);

}  // namespace vantage
