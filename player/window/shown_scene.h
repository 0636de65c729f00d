#pragma once
#include <optional>
#include <string>
#include <vector>

#include "player/interface/layout.h"
#include "player/interface/overlays/comparison.h"
#include "player/interface/photo_strip.h"
#include "player/interface/sections/controls.h"
#include "player/interface/sections/cut_section.h"
#include "player/interface/sections/open_dialog.h"
#include "player/interface/tour/story_editor.h"
#include "player/interface/tour/story_panel.h"
#include "player/interface/tour/unsaved_changes.h"
#include "player/interface/undo.h"
#include "player/window/input/file_manager.h"
#include "player/window/input/system_chooser.h"
#include "player/window/kiosk.h"
#include "player/window/loaded_scene.h"
#include "player/window/orthophoto_writer.h"
#include "player/window/path_recorder.h"
#include "player/window/window_picture.h"

namespace vantage {

/// Shows a scene in the window, frame by frame: its picture, and the interface over it. The package, the
/// session and the controls must outlive it.
class ShownScene {
  public:
    ShownScene(const PackageReader& package, const std::vector<SceneObject>& objects,
               const ShowOptions& options, Session& session, Controls& controls);

    /// Draws the view if it has changed or is not final, and the interface over it.
    void frame(int width, int height, double now);
    /// The part of frame() that does not need OpenGL: updates the session according to its input and the
    /// time, and builds the interface. Returns the view.
    View update(int width, int height, double now);
    /// Draws the view without showing it.
    void draw_unseen(const View& view, double now);
    /// Writes the path that is being recorded, if any.
    void stop_recording(double now);
    /// Whether the picture is final, so that nothing changes before wakes_at() without input.
    bool rests() const { return picture_.is_final() && !session_.viewpoint.flight; }
    /// The time of the next frame at rest, in seconds.
    double wakes_at() const;
    const PlanScene& scene() const { return scene_.plan(); }

  private:
    static constexpr double blink_seconds = 0.3;  ///< blinking interval of a text field's cursor

    std::optional<AttractLoop> kiosk_tour(const PackageReader& package, const std::string& path) const;
    void choose_projection(double now);
    RenderSettings shown_settings() const;
    void draw_picture(const View& view, const RenderSettings& shown, double now);
    bool lacks_thumbnails() const { return layout_.strip.height > 0 && strip_.lacks_pictures(); }
    void pick(const View& view);
    void interface(const View& view, double now);
    void panels(const View& view, double now);
    void dialogs(double now);
    void tell(const View& view, double now);
    void tour_caption(double now);
    void invite(double now);
    void add_objects(double now);
    void show_cut(const View& view);

    LoadedScene scene_;
    WindowPicture picture_;
    Session& session_;
    Controls& controls_;
    PhotoStrip strip_;
    OpenDialog open_dialog_;
    std::string dropped_;  ///< see drop_dialog()
    Layout layout_;
    PictureArea picture_area_;
    CutLines cut_lines_;
    UnseenLegend unseen_legend_;
    StoryEditor story_editor_;
    UndoHistory undo_;
    UnsavedChanges unsaved_changes_;
    double shown_at_ = 0;
    std::optional<Kiosk> kiosk_;
    PathRecorder path_recorder_;
    OrthophotoWriter orthophotos_;
    SystemChooser chooser_;
    FileManager file_manager_;
};

}  // namespace vantage
