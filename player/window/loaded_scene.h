#pragma once
#include <string>
#include <vector>

#include "player/composition/object_set.h"
#include "player/interface/sections/measure_panel.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"
#include "player/interface/tour/note_picture.h"
#include "player/options/show_options.h"
#include "player/render/renderer.h"
#include "player/window/input/asked_files.h"

namespace vantage {

/// A scene in a window or a headset: a package and the packages added to it, with the scene's story,
/// measurements and output files. Must be used on the OpenGL thread.
struct LoadedScene {
    /// Fits the session to the scene. The package must outlive it.
    LoadedScene(const PackageReader& package, const std::vector<SceneObject>& all, const ShowOptions& options,
                Session& session);

    /// Applies the language of the window, uploads the open note's picture once it is loaded, and hides the
    /// pieces that the story hides. Returns whether these have changed.
    bool attend(const Session& session);

    bool hide_pieces();
    const PackageReader& package() const { return renderer.package(); }
    const PlanScene& plan() const { return renderer.scene(); }

    Renderer renderer;
    ObjectSet objects;
    MeasurePanel measure;
    ActiveStory active;
    NotePicture note_picture;
    AskedFiles asked_files;
    std::string language;           ///< in use
    std::vector<StoryBall> hidden;  ///< in the picture
};

}  // namespace vantage
