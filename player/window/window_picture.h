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

/// The picture of a scene in the window, under the interface: drawn at a pace that keeps the frame rate while
/// something moves, refined when it rests, until it is final. The scene and the session must outlive it.
class WindowPicture {
  public:
    WindowPicture(LoadedScene& scene, const ShowOptions& options, Session& session);

    /// Draws the view, unless the picture is final, but shows it nowhere.
    void draw(const View& view, const RenderSettings& shown, double now);
    /// Shows what was drawn last.
    void show(const RenderSettings& shown, double now);
    /// Before and after what the graphics card does for a frame. Sets the pace of those to come.
    void begin_frame() { clock_.begin(); }
    void end_frame(double now);

    /// A picture was drawn.
    bool drawn() const { return drawn_; }
    /// The last one, whose frame may be smaller than the window.
    const View& drawn_view() const { return *drawn_view_; }
    /// The picture has all its samples.
    bool is_final() const { return samples_ >= rest_side * rest_side; }
    /// Something in it has changed that the session does not tell.
    void refine_again() { samples_ = 0; }
    /// Pictures of two eyes divide the window: what is drawn over the whole picture would be in the wrong
    /// places.
    bool in_parts() const;
    /// When tiles that are missing or damaged are looked for again, seconds.
    double looks_again_at() const { return looks_again() ? drawn_at_ + look_again_seconds : HUGE_VAL; }

  private:
    static constexpr int rest_side = 2;            ///< samples per side of a pixel at rest
    static constexpr double rest_seconds = 10;     ///< after a change, the picture is final
    static constexpr double still_seconds = 0.25;  ///< without motion, before a coarse frame is refined
    static constexpr double slow_ms = 100;         ///< a frame that takes longer may wait for tiles
    static constexpr double look_again_seconds = Residency::retry_seconds + 1;

    bool unchanged(const View& view, const RenderSettings& shown) const;
    bool looks_again() const;
    void draw_sample(const View& view, const RenderSettings& shown, bool still, double now);
    void draw_eyes(const RenderSettings& shown, const RenderSettings& settings, PixelSample sample,
                   double now, const View* next);
    /// The pictures of two eyes are shown.
    bool stereo() const;
    bool lacks_time(double now) const;
    bool in_motion(const View& view) const;
    void keep_pace();
    void tell_memory(double now);

    LoadedScene& scene_;
    Session& session_;
    std::uint64_t memory_limit_;  ///< asked for, bytes; 0: none, or it was said that frames need more
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
    bool same_settings_ = false;  ///< as in the frame before
    double drawn_at_ = 0, moved_at_ = 0, changed_at_ = 0;
};

}  // namespace vantage
