#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "player/composition/enlargement.h"
#include "player/composition/stereo_picture.h"
#include "player/interface/state/session.h"
#include "player/options/show_options.h"
#include "player/render/timing/frame_clock.h"
#include "player/window/loaded_scene.h"

namespace vantage {

/// The picture of a scene in the window, under the interface. In motion, it is drawn at a pace that maintains
/// the frame rate; at rest, it is refined until it is final. The scene and the session must outlive it.
class WindowPicture {
  public:
    WindowPicture(LoadedScene& scene, const ShowOptions& options, Session& session);

    /// Draws the view, unless the picture is final, without showing it.
    void draw(const View& view, const RenderSettings& shown, double now);
    /// Shows the last drawn picture.
    void show(const RenderSettings& shown, double now);
    /// Call these before and after the GPU work of a frame. The measured time sets the pace of later frames.
    void begin_frame() { clock_.begin(); }
    void end_frame(double now);

    /// Whether a picture was drawn.
    bool drawn() const { return drawn_; }
    /// Whether the frame at `now` seconds was drawn, instead of showing the last picture again.
    bool drawn_at(double now) const { return drawn_at_ == now; }
    /// The last view drawn, whose frame may be smaller than the window.
    const View& drawn_view() const { return *drawn_view_; }
    /// Whether the picture has all its samples.
    bool is_final() const { return samples_ >= rest_side * rest_side; }
    /// Restarts refinement after a change that the session does not record.
    void refine_again() { samples_ = 0; }
    /// Whether stereo divides the window into two pictures, over which overlays for the whole picture would
    /// be misplaced.
    bool in_parts() const;
    /// The time at which missing or damaged tiles are requested again, in seconds.
    double looks_again_at() const { return looks_again() ? drawn_at_ + look_again_seconds : HUGE_VAL; }

  private:
    static constexpr int rest_side = 2;            ///< samples per side of a pixel at rest
    static constexpr double rest_seconds = 10;     ///< maximum time from a change until the picture is final
    static constexpr double still_seconds = 0.25;  ///< pause after a motion before a coarse frame is refined
    static constexpr double slow_ms = 100;         ///< frames that take longer may wait for tiles
    static constexpr double look_again_seconds = Residency::retry_seconds + 1;

    bool unchanged(const View& view, const RenderSettings& shown) const;
    bool looks_again() const;
    void draw_sample(const View& view, const RenderSettings& shown, bool still, double now);
    void draw_eyes(const RenderSettings& shown, const RenderSettings& settings, PixelSample sample,
                   double now, const View* next);
    /// Whether pictures for two eyes are shown.
    bool stereo() const;
    bool lacks_time(double now) const;
    bool in_motion(const View& view, bool still) const;
    bool waits_for_tiles() const;
    void keep_pace();
    void tell_memory(double now);

    LoadedScene& scene_;
    Session& session_;
    std::uint64_t memory_limit_;  ///< requested limit in bytes; 0: none, or the user was already notified
    FrameClock clock_;
    Enlargement enlargement_;
    StereoPicture pair_;
    double goal_ms_;      ///< target for frames in motion; if 0, frames always have full size
    Pacing pacing_;       ///< pace of frames in motion
    double full_ms_ = 0;  ///< estimated duration of a full frame that loads nothing; 0: unknown
    std::optional<View> last_, drawn_view_;
    RenderSettings last_settings_;  ///< settings of the last frame
    StereoSettings last_stereo_;    ///< likewise
    std::vector<std::uint32_t> last_photos_;
    std::optional<Navigation> before_;
    int samples_ = 0;
    bool drawn_ = false, resting_ = false;
    bool same_settings_ = false;  ///< the settings are the same as in the previous frame
    double drawn_at_ = 0, moved_at_ = 0, changed_at_ = 0;
};

}  // namespace vantage
