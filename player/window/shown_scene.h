#pragma once
#include <optional>

#include "player/composition/enlargement.h"
#include "player/composition/stereo_picture.h"
#include "player/interface/layout.h"
#include "player/interface/photo_strip.h"
#include "player/interface/sections/controls.h"
#include "player/interface/sections/cut_section.h"
#include "player/interface/sections/measure_panel.h"
#include "player/interface/sections/open_dialog.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/story_editor.h"
#include "player/interface/tour/story_panel.h"
#include "player/interface/tour/told_story.h"
#include "player/options/show_options.h"
#include "player/render/frame_clock.h"
#include "player/render/renderer.h"
#include "player/window/input/asked_files.h"
#include "player/window/input/system_chooser.h"
#include "player/window/kiosk.h"
#include "player/window/orthophoto_writer.h"

namespace vantage {

/// Shows a scene in the window, frame by frame: a package, and others that were added to it. The package, the
/// session and the controls must outlive it.
class ShownScene {
  public:
    ShownScene(const PackageReader& package, const std::vector<SceneObject>& objects,
               const ShowOptions& options, Session& session, Controls& controls);

    /// Draws the view if it has changed or can still improve, and the interface over it.
    void frame(int width, int height, double now);
    /// The part of frame() that needs no graphics card: lets the session act on its input and on time, and
    /// makes the interface. Returns the view.
    View update(int width, int height, double now);
    /// Draws the view, but shows it nowhere.
    void draw_unseen(const View& view, double now);
    /// Writes the path that is being recorded, if there is one.
    void stop_recording(double now);
    /// The picture is final: without input, nothing changes before wakes_at().
    bool rests() const { return is_final() && !session_.viewpoint.flight; }
    /// When the next frame is due at rest, in seconds.
    double wakes_at() const;
    Renderer& renderer() { return renderer_; }

  private:
    static constexpr int rest_side = 2;            ///< samples per side of a pixel at rest
    static constexpr double rest_seconds = 10;     ///< after a change, the picture is final
    static constexpr double still_seconds = 0.25;  ///< without motion, before a coarse frame is refined
    static constexpr double slow_ms = 100;         ///< a frame that takes longer may wait for tiles
    static constexpr double look_again_seconds = Residency::retry_seconds + 1;
    static constexpr double blink_seconds = 0.3;  ///< of a text field's cursor

    std::optional<AttractLoop> kiosk_tour(const PackageReader& package, const std::string& path) const;
    void choose_projection(double now);
    RenderSettings shown_settings() const;
    void interface(const View& view, double now);
    void tell(const View& view, double now);
    void record(double now);
    void save_recorded(double now);
    void add_objects(double now);
    void show_cut(const View& view);
    bool unchanged(const View& view, const RenderSettings& shown) const;
    bool looks_again() const;
    /// The picture has all its samples.
    bool is_final() const { return samples_ >= rest_side * rest_side; }
    void draw_view(const View& view, const RenderSettings& shown, double now);
    void remember_drawn(const View& view, const RenderSettings& shown);
    void draw(const View& view, const RenderSettings& shown, bool still, double now);
    void draw_eyes(const RenderSettings& shown, const RenderSettings& settings, PixelSample sample,
                   double now, const View* next);
    void show(const RenderSettings& shown, double now);
    /// The pictures of two eyes are shown.
    bool stereo() const;
    bool in_parts() const;
    void pick(const View& view);
    bool lacks_time(double now) const;
    bool in_motion(const View& view) const;
    void keep_pace();
    void tell_memory(double now);

    Renderer renderer_;
    ObjectSet objects_;
    Session& session_;
    Controls& controls_;
    std::uint64_t memory_limit_;  ///< asked for, bytes; 0: none, or it has been told that frames need more
    PhotoStrip strip_;
    OpenDialog open_dialog_;
    std::string dropped_;  ///< see drop_dialog()
    Layout layout_;
    MeasurePanel measure_;
    CutLines cut_lines_;
    std::string language_;  ///< in use
    ToldStory told_;
    NotePicture note_picture_;
    StoryEditor story_editor_;
    FrameClock clock_;
    Enlargement enlargement_;
    StereoPicture pair_;
    double goal_ms_;       ///< of a frame in motion; 0: none, frames are always drawn at full size
    Pacing pacing_;        ///< of frames in motion
    double frame_ms_ = 0;  ///< of the last frame that was measured
    std::optional<View> last_, drawn_view_;
    RenderSettings last_settings_;  ///< of the last frame, as are the photos
    StereoSettings last_stereo_;    ///< likewise
    std::vector<std::uint32_t> last_photos_;
    std::optional<Navigation> before_;
    int samples_ = 0;
    bool drawn_ = false, resting_ = false;
    double drawn_at_ = 0, shown_at_ = 0, moved_at_ = 0, changed_at_ = 0;
    struct Recording {
        double begin;
        Navigation last;  ///< of the last frame
        double last_at;
    };
    std::optional<Recording> recording_;
    std::optional<Kiosk> kiosk_;
    AskedFiles asked_files_;
    OrthophotoWriter orthophotos_;
    SystemChooser chooser_;
};

}  // namespace vantage
