#pragma once
#include <filesystem>

#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"
#include "player/options/show_options.h"
#include "player/window/remembered.h"

namespace vantage {

/// Throws Error(damaged) if there is neither a photo nor a point, or if META is damaged, although META is not
/// needed for display.
void expect_content(const PackageReader& package);

/// The settings from the command line, or else those saved in the folder, if any.
Remembered start_settings(const PackageReader& package, const ShowOptions& options,
                          const std::filesystem::path& folder);

/// The language from the command line, or else the saved language, or else the system's.
std::string chosen_language(const ShowOptions& options, const Remembered& remembered);

/// A session that starts at the first photo of --photo, or at the middle photo. Without photos, it starts in
/// front of the model.
Session start_session(const PackageReader& package, const ShowOptions& options, const Remembered& remembered,
                      WindowState& window);

/// Initializes a session for the loaded scene: the photos in use and their errors, the story's background,
/// and the story's first view unless the command line gives a view.
void begin_in_scene(Session& session, const PackageReader& package, const ActiveStory& active,
                    const ShowOptions& options);

}  // namespace vantage
