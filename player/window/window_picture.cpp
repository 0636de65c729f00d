#include "player/window/window_picture.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/gl/context.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/options/frame_goal.h"
#include "player/view/camera_path.h"

namespace vantage {
namespace {

/// The order of a pixel's samples: each pair of them is centered, so that the picture does not shift.
constexpr std::array sample_order{0, 3, 1, 2};

/// A frame that takes longer than a thirtieth of a second may upload as much as the frames that it replaces:
/// this hardly prolongs the frame, and the picture is complete earlier.
std::size_t upload_of_frame(std::size_t bytes, double ms) {
    return std::size_t(double(bytes) * std::clamp(ms * 30 / 1000, 1.0, 64.0));
}

/// The area of an eye's picture of this size that is free of panels, in a window whose free area is `free`.
/// If the pictures are side by side, a side panel covers only one of them; if they are above each other, a
/// panel at the bottom does.
Area free_for_eye(StereoMode mode, const Area& free, FrameSize size) {
    Area out = free;
    if (mode == StereoMode::side_by_side) out.left = 0, out.width = size.width;
    if (mode == StereoMode::over_under) out.top = 0, out.height = size.height;
    return out;
}

/// The first picture consists of base levels, so a software renderer need not draw it at a higher resolution.
Pace pace_of_first_picture(double goal) {
    return goal > 0 && gl::current_device().software ? coarse_pace : Pace{};
}

}  // namespace

WindowPicture::WindowPicture(LoadedScene& scene, const ShowOptions& o, Session& session)
    : scene_(scene),
      session_(session),
      memory_limit_(memory_budget(o.memory).graphics),
      clock_(gl::current_device().software),
      goal_ms_(frame_goal(o.window.fps)),
      pacing_{pace_of_first_picture(goal_ms_)} {}

void WindowPicture::draw(const View& view, const RenderSettings& shown, double now) {
    if (goal_ms_ > 0) enlargement_.fit(shown.capacity);
    const bool still = unchanged(view, shown);
    if (!still) samples_ = 0;
    if (last_ && frame_size(*last_) != frame_size(view)) full_ms_ = 0;
    draw_sample(view, shown, still, now);
    same_settings_ = shown == last_settings_;
    last_ = view;
    last_settings_ = shown;
    last_stereo_ = session_.stereo;
    last_photos_ = session_.photos;
}

void WindowPicture::end_frame(double now) {
    clock_.end(drawn_at_ == now ? std::optional(session_.drawn.pace) : std::nullopt);
    keep_pace();
}

/// A damaged package may be repaired while it is open, and a server may become available again.
bool WindowPicture::looks_again() const {
    return session_.drawn.report.tiles_damaged + session_.drawn.report.tiles_absent > 0;
}

/// Whether the last frame was drawn for the same view, photos and settings.
bool WindowPicture::unchanged(const View& view, const RenderSettings& shown) const {
    RenderSettings drawn = last_settings_;
    drawn.swipe = shown.swipe;  // swipe only affects display
    return drawn_ && last_ && same_view(*last_, view) && drawn == shown && last_stereo_ == session_.stereo &&
           last_photos_ == session_.photos;
}

/// While the view moves or tiles are missing, draws one sample per pixel, half a level sharper. In motion,
/// adjusts the pace so that the frame rate meets its goal. Afterward, accumulates the samples of each pixel,
/// one per frame, and stops when the picture is final. If full frames are slow, the first of them waits for
/// its tiles and is already a sample.
void WindowPicture::draw_sample(const View& view, const RenderSettings& shown, bool still, double now) {
    Session& s = session_;
    if (looks_again() && now > drawn_at_ + look_again_seconds) samples_ = 0;
    if (still && is_final()) return;
    if (!still) changed_at_ = now;
    if (in_motion(view, still)) moved_at_ = now;
    // A coarse frame is refined after the motion has ended, not between two mouse movements.
    const bool moves = now < moved_at_ + still_seconds && !holds<SaveScreenshot>(s.window.commands);
    const bool complete = drawn_ && s.drawn.pace == Pace{} && s.drawn.report.settled;
    if (still && !moves && !resting_ && complete && lacks_time(now)) {
        samples_ = rest_side * rest_side;
        return;
    }
    const bool waits = drawn_ && !moves && waits_for_tiles();
    s.drawn.pace = moves || !drawn_ ? pacing_.pace : Pace{};
    drawn_at_ = now;
    // The picture stays at rest while tiles arrive: if not all tiles fit, those for motion and those for rest
    // would otherwise evict each other.
    resting_ = !moves && ((still && (resting_ || complete)) || (waits && !lacks_time(now)));
    RenderSettings settings = shown;
    settings.reduced = s.drawn.pace.reduced;
    settings.lod_bias = resting_ ? 0 : -0.5;
    if (!moves) settings.upload_bytes = upload_of_frame(settings.upload_bytes, full_ms_);
    if (waits) settings.loading = Loading::uploading;
    if (!drawn_ && !scene_.package().remote()) settings.loading = Loading::beginning;  // with photos
    const Navigation ahead = before_ ? between(*before_, s.viewpoint.camera, 4) : s.viewpoint.camera;
    before_ = s.viewpoint.camera;
    const View next =
        scaled(shown_view(ahead, s, scene_.plan(), view.intrinsics.width, view.intrinsics.height),
               s.drawn.pace.scale);
    const PixelSample sample =
        resting_ ? PixelSample{sample_order.at(std::size_t(samples_)), rest_side} : PixelSample{};
    const bool valid_so_far = s.drawn.report.tiles_damaged == 0;
    drawn_view_ = scaled(view, s.drawn.pace.scale);
    // At rest, nothing is prefetched, since that would restart or delay the samples.
    const View* const ahead_of = moves ? &next : nullptr;
    if (stereo())
        draw_eyes(shown, settings, sample, now, ahead_of);
    else
        s.drawn.report = scene_.objects.draw(*drawn_view_, settings, s.photos, sample, now, ahead_of);
    samples_ = resting_ && s.drawn.report.settled ? samples_ + 1 : 0;
    if (s.drawn.report.tiles_damaged > 0 && valid_so_far)
        say(s.message,
            tr("The package is damaged: parts of the picture are missing or blurred (vantage check FILE)"),
            now);
    tell_memory(now);
    drawn_ = true;
}

/// Whether the next full frame waits for tiles, which hardly prolongs it.
bool WindowPicture::waits_for_tiles() const { return full_ms_ > slow_ms && !scene_.package().remote(); }

/// Stereo is off for orthographic views, which are the same for both eyes, and for comparisons, whose photo
/// exists only for one eye.
bool WindowPicture::stereo() const {
    return session_.stereo.mode != StereoMode::off && !session_.viewpoint.orthographic &&
           session_.settings.compare == Compare::nothing;
}

bool WindowPicture::in_parts() const { return stereo() && divides_frame(session_.stereo.mode); }

/// The eyes converge at the camera's target.
void WindowPicture::draw_eyes(const RenderSettings& shown, const RenderSettings& settings, PixelSample sample,
                              double now, const View* next) {
    Session& s = session_;
    const FrameSize size = eye_size(s.stereo.mode, shown.capacity);
    const double distance = (s.viewpoint.camera.target - s.viewpoint.camera.eye).norm();
    const Area free = free_for_eye(s.stereo.mode, s.window.picture, size);
    const View middle =
        scaled(view_of(s.viewpoint.camera, size.width, size.height, free), s.drawn.pace.scale);
    const std::vector<View> eyes = eye_views(middle, s.stereo.eyes, distance);
    pair_.fit(size);
    s.drawn.report =
        scene_.objects.draw_eyes({eyes, settings, s.photos, sample, now, next}, [&](std::size_t eye) {
            enlargement_.show(scene_.objects, eyes[eye], shown, size, {pair_.target(eye), false, eye});
        });
    drawn_view_ = eyes.front();
}

void WindowPicture::show(const RenderSettings& shown, double now) {
    if (stereo()) return pair_.show(session_.stereo.mode, shown.capacity, 0, true);
    if (is_final() && drawn_at_ != now && same_settings_)
        enlargement_.show_again(scene_.objects, *drawn_view_, shown, shown.capacity, {0, true});
    else
        enlargement_.show(scene_.objects, *drawn_view_, shown, shown.capacity, {0, true});
}

/// Whether the samples of a picture at rest would keep the CPU busy for too long: with a software renderer on
/// a large screen, the picture is not refined.
bool WindowPicture::lacks_time(double now) const {
    constexpr double samples = 3;  // after the first one
    return now + samples * full_ms_ / 1000 > changed_at_ + rest_seconds;
}

/// Whether the view differs from the last one, or a control that is being dragged has changed the picture.
bool WindowPicture::in_motion(const View& view, bool still) const {
    const bool dragged = !still && ImGui::IsMouseDragging(0) && ImGui::IsAnyItemActive();
    return dragged || (last_ && !same_view(*last_, view));
}

/// Records the durations of finished frames, and sets the pace of later ones.
void WindowPicture::keep_pace() {
    const auto frame = clock_.take();
    if (!frame) return;
    note_time(session_.drawn, frame->ms);
    if (frame->pace == Pace{} || full_ms_ == 0) {
        const double scale = frame->pace.scale, loading = session_.drawn.report.uploaded > 0 ? 2 : 1;
        full_ms_ = frame->ms / (scale * scale * loading);
    }
    if (frame->pace != Pace{} || (pacing_.pace == Pace{} && pacing_.full_frame_ms > 0)) {
        pacing_ = next_pacing(pacing_, frame->pace, frame->ms, goal_ms_);
        return;
    }
    // Frames at rest are slower than frames in motion, so if the former meet the goal, the latter do too.
    const Pace first = first_pace(frame->ms, goal_ms_);
    if (pacing_.pace == Pace{} || first == Pace{} || first.scale > pacing_.pace.scale) pacing_ = {first};
}

/// Reports once that frames of this size need more graphics memory than allowed.
void WindowPicture::tell_memory(double now) {
    const std::uint64_t used = scene_.objects.graphics_budget();
    if (memory_limit_ == 0 || used <= memory_limit_) return;
    say(session_.message,
        formatted(tr("Frames of this size need %.0f MiB of graphics memory, which is more than "
                     "--graphics-memory allows"),
                  double((used >> 20) + 1)),
        now);
    memory_limit_ = 0;
}

}  // namespace vantage
