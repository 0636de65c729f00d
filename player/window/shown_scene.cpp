#include "player/window/shown_scene.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/help_panel.h"
#include "player/interface/menu_bar.h"
#include "player/interface/message_line.h"
#include "player/interface/overlays/comparison.h"
#include "player/interface/overlays/frusta.h"
#include "player/interface/overlays/radar_panel.h"
#include "player/interface/overlays/surface_at_pixel.h"
#include "player/interface/sections/object_section.h"
#include "player/interface/sections/photo_list_section.h"
#include "player/interface/sidebar.h"
#include "player/interface/tour/visitor_bar.h"
#include "player/options/frame_goal.h"
#include "player/survey/photo_errors.h"
#include "player/tour/story_background.h"
#include "player/view/camera_path.h"
#include "player/window/input/asked_files.h"
#include "player/window/input/numbered_file.h"
#include "player/window/input/view_clipboard.h"
#include "player/window/screenshot.h"
#include "player/window/start_session.h"

namespace vantage {

namespace {

/// A pixel of a frame in another one that shows the same.
Eigen::Vector2d pixel_in(const Intrinsics& to, const Intrinsics& from, const Eigen::Vector2d& pixel) {
    return {pixel.x() * to.width / from.width, pixel.y() * to.height / from.height};
}

/// Where a frame takes longer than a thirtieth of a second, it may upload as much as those that it replaces:
/// that makes it hardly longer, and the picture is there sooner.
std::size_t upload_of_frame(std::size_t bytes, double ms) {
    return std::size_t(double(bytes) * std::clamp(ms * 30 / 1000, 1.0, 64.0));
}

/// Where other packages are likely to be.
std::filesystem::path package_folder(const PackageReader& package) {
    return package.remote() ? std::filesystem::path(".") : package.path().parent_path();
}

/// What is free for an eye's picture, of this size, in its part of a window of which `free` is: panels at the
/// sides are over one eye's picture, and so are those below if the pictures are above each other.
Area free_for_eye(StereoMode mode, const Area& free, FrameSize size) {
    Area out = free;
    if (mode == StereoMode::side_by_side) out.left = 0, out.width = size.width;
    if (mode == StereoMode::over_under) out.top = 0, out.height = size.height;
    return out;
}

/// The first picture is made of thumbnails: in software, it need not wait for the pixels between theirs.
Pace pace_of_first_picture(double goal) {
    return goal > 0 && gl::current_device().software ? coarse_pace : Pace{};
}

}  // namespace

ShownScene::ShownScene(const PackageReader& package, const std::vector<SceneObject>& objects,
                       const ShowOptions& o, Session& session, Controls& controls)
    : renderer_(package, memory_budget(o.memory)),
      objects_(renderer_, objects, memory_budget(o.memory)),
      session_(session),
      controls_(controls),
      memory_limit_(memory_budget(o.memory).graphics),
      open_dialog_(package_folder(package)),
      measure_(package),
      language_(session.window.language),
      told_(told_story(o.package.file, input_axes(package), session.window.language)),
      clock_(gl::current_device().software),
      goal_ms_(frame_goal(o.window.fps)),
      pacing_{pace_of_first_picture(goal_ms_)} {
    begin_in_scene(session_, package, told_, o);
    if (!o.window.kiosk) return;
    const StoryAttract told = told_.story.attract.value_or(StoryAttract{});
    const double home_after = o.window.home_after > 0 ? o.window.home_after : told.after;
    kiosk_ = make_kiosk(session, kiosk_tour(package, o.window.tour), home_after);
}

/// Along the path of the command line, or else as the story says.
std::optional<AttractLoop> ShownScene::kiosk_tour(const PackageReader& package,
                                                  const std::string& path) const {
    if (path.empty()) try {
            return attract_loop(told_.story, session_.viewpoint.home, told_.axes, told_.file.string());
        } catch (const Error& e) {  // the rest of the story can be shown
            say(session_.message, e.what(), 0);
            return {};
        }
    std::vector<Navigation> stops =
        recorded_stops(path, package, (session_.viewpoint.home.target - session_.viewpoint.home.eye).norm());
    if (stops.size() < 2) return {};
    const double seconds = double(stops.size() - 1) / positions_per_second;
    return AttractLoop{std::move(stops), {}, seconds};
}

void ShownScene::frame(int width, int height, double now) {
    Session& s = session_;
    const View view = update(width, height, now);
    s.settings.points.pick = s.window.panels.expert && s.window.panels.points;
    const RenderSettings shown = shown_settings();
    clock_.begin();
    draw_view(view, shown, now);
    if (s.settings.points.pick) pick(view);
    show(shown, now);
    while (take<SaveScreenshot>(s.window.commands))
        write_numbered(s.message, renderer_.package().path().stem().string(), ".png", tr("screenshot"), now,
                       [&](const std::string& file) { save_frame(file, width, height); });
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    clock_.end(drawn_at_ == now ? std::optional(s.drawn.pace) : std::nullopt);
    keep_pace();
    remember_drawn(view, shown);
}

void ShownScene::draw_unseen(const View& view, double now) {
    const RenderSettings shown = shown_settings();
    draw_view(view, shown, now);
    remember_drawn(view, shown);
}

View ShownScene::update(int width, int height, double now) {
    Session& s = session_;
    if (kiosk_) attend(*kiosk_, s, s.window.touched, now);
    follow_language(told_, language_, s.window.language);
    use_clipboard(s, renderer_.package(), now);
    continue_flight(s.viewpoint, now);
    continue_tour(told_, s.viewpoint, now);
    note_view(s.viewpoint, now);
    layout_ = layout_of(s.window.panels, width, height, double(ImGui::GetFontSize()),
                        !renderer_.scene().photos.empty());
    s.window.free = picture_area(layout_, s.settings.compare, width);
    s.settings.room = {width, height};
    choose_projection(now);
    View view = shown_view(s.viewpoint.camera, s, renderer_.scene(), width, height);
    shown_at_ = now;
    if (take_all<CloseMenus>(s.window.commands)) controls_.close_menus();
    note_picture_.attend();
    interface(view, now);
    record(now);
    add_objects(now);
    asked_files_.attend(s, renderer_.package(), objects_, now);
    orthophotos_.attend(s, renderer_.package(), now);
    ImGui::Render();
    return view;
}

/// Unless the picture is final.
void ShownScene::draw_view(const View& view, const RenderSettings& shown, double now) {
    if (goal_ms_ > 0) enlargement_.fit(shown.room);
    const bool still = unchanged(view, shown);
    if (!still) samples_ = 0;
    draw(view, shown, still, now);
}

void ShownScene::remember_drawn(const View& view, const RenderSettings& shown) {
    last_ = view;
    last_settings_ = shown;
    last_stereo_ = session_.stereo;
    last_photos_ = session_.photos;
}

/// What an orthographic view cannot show ends it.
void ShownScene::choose_projection(double now) {
    Session& s = session_;
    const bool points = renderer_.points() && s.settings.points.show;
    if (!s.viewpoint.orthographic ||
        (!points && s.settings.compare == Compare::nothing && objects_.size() == 1))
        return;
    s.viewpoint.orthographic = false;
    say(s.message,
        tr("In perspective again: points, several objects and comparisons are not shown orthographically"),
        now);
}

/// Those of the session. An orthographic view leaves out background, and so does a cut, which they would
/// fill with what it takes away.
RenderSettings ShownScene::shown_settings() const {
    RenderSettings settings = session_.settings;
    if (session_.viewpoint.orthographic || !settings.sections.empty())
        settings.background = ShowBackground::off;
    return settings;
}

void ShownScene::interface(const View& view, double now) {
    Session& s = session_;
    if (s.window.panels.bar) visitor_bar(controls_, s, renderer_, view, layout_.bar, now);
    if (!drawn_) return;  // the rest would delay the first picture
    const bool overlays = !in_parts();
    if (s.window.panels.frusta && overlays) frusta(s, renderer_, strip_, view, now);
    pick_listed_point(s, renderer_.scene(), view);
    const Intrinsics& frame = view.intrinsics;
    comparison(controls_, s, renderer_.scene(), {0, 0, double(frame.width), double(frame.height)});
    false_color_legend(controls_, s);
    if (s.window.panels.expert) {
        menu_bar(controls_, s, renderer_, now);
        if (sidebar(controls_, s, renderer_, objects_, view, layout_.sidebar, now)) samples_ = 0;
    }
    show_cut(view);
    measure_.show(controls_, s,
                  s.window.panels.measure && overlays ? objects_.meshes() : std::vector<PlacedMesh>{}, view,
                  now);
    if (s.window.panels.radar)
        radar_panel(controls_, s, renderer_, view_of(s.viewpoint.camera, frame.width, frame.height), now);
    if (layout_.strip.height > 0) strip_.show(controls_, s, renderer_, view, layout_.strip, now);
    tell(view, now);
    if (s.window.panels.help) help_panel(controls_, s.window);
    chooser_.attend(s.window.commands, s.message, package_folder(renderer_.package()), now);
    open_dialog_.show(controls_, s.window);
    drop_dialog(controls_, s.window.commands, dropped_);
    message_line(controls_, s.message, s.window.free, now);
    s.window.menu_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

/// Cuts the model as the session says, and draws where it is cut.
void ShownScene::show_cut(const View& view) {
    Session& s = session_;
    const auto& planes = s.settings.sections = sections_of(s.cut, renderer_.scene());
    const bool hidden = planes.empty() || in_parts();
    cut_lines_.show(hidden ? std::vector<PlacedMesh>{} : objects_.meshes(), planes, view);
}

/// Notes, their cards and tours, over the picture of `view`.
void ShownScene::tell(const View& view, double now) {
    Session& s = session_;
    const SeenTriangles seen = renderer_.seen();
    const SurfaceAt surface = [&](const Eigen::Vector2d& pixel) {
        return surface_at_pixel(renderer_.scene(), seen,
                                pixel_in(seen.view.intrinsics, view.intrinsics, pixel));
    };
    if (s.window.panels.story_editor)
        story_editor_.show(controls_, told_, s, view, surface, &s.window.panels.story_editor, now);
    if (!s.window.panels.story) return;
    if (told_.any() || !told_.trouble.empty()) story_panel(controls_, told_, s, &s.window.panels.story, now);
    if (in_parts()) return;
    const auto clicked = draw_note_markers(controls_, note_markers(told_.story, told_.axes, view, surface),
                                           told_.story, told_.language, told_.open);
    if (clicked) open_note(told_, s.viewpoint, *clicked, now);
    note_card(controls_, told_, note_picture_, s, now);
}

double ShownScene::wakes_at() const {
    double at = kiosk_ ? attends_at(*kiosk_) : HUGE_VAL;
    if (!session_.message.text.empty()) at = session_.message.shown ? session_.message.until : shown_at_;
    if (asked_files_.busy() || note_picture_.loading() || measure_.saves())
        at = std::min(at, shown_at_ + 0.05);
    if (orthophotos_.writes() || chooser_.asks()) at = std::min(at, shown_at_ + 0.5);
    if (looks_again()) at = std::min(at, drawn_at_ + look_again_seconds);
    if (ImGui::GetIO().WantTextInput) at = std::min(at, shown_at_ + blink_seconds);
    if (layout_.strip.height > 0) at = std::min(at, strip_.ranks_at());
    const auto traffic = renderer_.package().traffic();
    if (traffic && traffic->bytes_per_second > 0) at = std::min(at, shown_at_ + 1);  // the status panel
    return at;
}

/// One position per 1 / positions_per_second, interpolated between frames. At rest, there were none because
/// the camera stood still.
void ShownScene::record(double now) {
    Session& s = session_;
    if (!recording_ || (s.path.recording && s.path.positions.empty())) {
        if (!s.path.recording) return;
        recording_ = Recording{now, s.viewpoint.camera, now};
    }
    if (is_final()) recording_->last_at = std::max(recording_->last_at, now - 1 / positions_per_second);
    const auto next = [&] {
        return recording_->begin + double(s.path.positions.size()) / positions_per_second;
    };
    for (double at; (at = next()) <= now;) {
        const double passed = now - recording_->last_at;
        const double share = passed > 0 ? std::clamp((at - recording_->last_at) / passed, 0.0, 1.0) : 1;
        s.path.positions.push_back(between(recording_->last, s.viewpoint.camera, share));
    }
    recording_->last = s.viewpoint.camera;
    recording_->last_at = now;
    if (s.path.recording) return;
    save_recorded(now);
    recording_.reset();
}

void ShownScene::stop_recording(double now) {
    session_.path.recording = false;
    record(now);
}

void ShownScene::save_recorded(double now) {
    Session& s = session_;
    if (s.path.positions.empty()) return;
    const PackageReader& package = renderer_.package();
    write_numbered(s.message, package.path().stem().string(), ".path",
                   formatted(tr("%zu positions"), s.path.positions.size()), now,
                   [&](const std::string& file) {
                       write_path(file, s.path.positions, package, {}, positions_per_second);
                   });
}

/// Adds the packages that the session asks for.
void ShownScene::add_objects(double now) {
    Session& s = session_;
    while (const auto added = take<AddObject>(s.window.commands)) try {
            objects_.add({std::filesystem::path(added->file).stem().string(), added->file, {}, true});
            s.window.panels.objects = true;
            samples_ = 0;
        } catch (const Error& e) {
            say(s.message, e.what(), now);
        }
}

/// A damaged package may be restored while it is shown, and a server may be reached again.
bool ShownScene::looks_again() const {
    return session_.drawn.report.tiles_damaged + session_.drawn.report.tiles_absent > 0;
}

/// Whether the last frame drew the same.
bool ShownScene::unchanged(const View& view, const RenderSettings& shown) const {
    RenderSettings drawn = last_settings_;
    drawn.swipe = shown.swipe;  // divides what was drawn
    return drawn_ && last_ && same_view(*last_, view) && drawn == shown && last_stereo_ == session_.stereo &&
           last_photos_ == session_.photos;
}

/// The point under the pointer.
void ShownScene::pick(const View& view) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    renderer_.pick(
        pixel_in(drawn_view_->intrinsics, view.intrinsics, {double(at.x), double(at.y)}).cast<int>());
}

/// While the view moves or tiles are missing, draws one sample per pixel, half a level sharper; at a pace
/// that keeps the goal while it moves. After that, accumulates the samples of each pixel, one per frame, and
/// stops when the picture is final.
void ShownScene::draw(const View& view, const RenderSettings& shown, bool still, double now) {
    Session& s = session_;
    if (looks_again() && now > drawn_at_ + look_again_seconds) samples_ = 0;
    if (layout_.strip.height > 0 && strip_.lacks_pictures()) samples_ = 0;
    if (still && is_final()) return;
    if (!still) changed_at_ = now;
    if (in_motion(view)) moved_at_ = now;
    // A coarse frame is refined when the motion has ended, not between two movements of the mouse.
    const bool moves = now < moved_at_ + still_seconds && !holds<SaveScreenshot>(s.window.commands);
    const bool complete = drawn_ && s.drawn.pace == Pace{} && s.drawn.report.settled;
    if (still && !moves && !resting_ && complete && lacks_time(now)) {
        samples_ = rest_side * rest_side;
        return;
    }
    s.drawn.pace = moves || !drawn_ ? pacing_.pace : Pace{};
    drawn_at_ = now;
    // Once at rest, it stays so while tiles come: where not all fit, those for motion and for rest would
    // evict each other.
    resting_ = still && !moves && (resting_ || complete);
    RenderSettings settings = shown;
    settings.swift = s.drawn.pace.swift;
    settings.lod_bias = resting_ ? 0 : -0.5;
    if (!moves) settings.upload_bytes = upload_of_frame(settings.upload_bytes, frame_ms_);
    settings.wait_for_uploads = !moves && frame_ms_ > slow_ms && !renderer_.package().remote();
    settings.wait_for_base = !drawn_ && !renderer_.package().remote();  // the first picture shows photos
    const Navigation ahead = before_ ? between(*before_, s.viewpoint.camera, 4) : s.viewpoint.camera;
    before_ = s.viewpoint.camera;
    const View next =
        scaled(shown_view(ahead, s, renderer_.scene(), view.intrinsics.width, view.intrinsics.height),
               s.drawn.pace.scale);
    const PixelSample sample = resting_ ? PixelSample{samples_, rest_side} : PixelSample{};
    const bool valid_so_far = s.drawn.report.tiles_damaged == 0;
    drawn_view_ = scaled(view, s.drawn.pace.scale);
    // For a picture at rest, nothing is prefetched: it would begin the samples again, or let them wait.
    const View* const ahead_of = moves ? &next : nullptr;
    if (stereo())
        draw_eyes(shown, settings, sample, now, ahead_of);
    else
        s.drawn.report = objects_.draw(*drawn_view_, settings, s.photos, sample, now, ahead_of);
    samples_ = resting_ && s.drawn.report.settled ? samples_ + 1 : 0;
    if (s.drawn.report.tiles_damaged > 0 && valid_so_far)
        say(s.message,
            tr("The package is damaged: parts of the picture are missing or blurred (vantage check FILE)"),
            now);
    tell_memory(now);
    drawn_ = true;
}

/// An orthographic view is the same for both eyes, and a comparison is with a photo for one.
bool ShownScene::stereo() const {
    return session_.stereo.mode != StereoMode::off && !session_.viewpoint.orthographic &&
           session_.settings.compare == Compare::nothing;
}

/// What is drawn over the whole picture would be in the wrong places.
bool ShownScene::in_parts() const { return stereo() && divides_frame(session_.stereo.mode); }

/// The eyes converge at the camera's target.
void ShownScene::draw_eyes(const RenderSettings& shown, const RenderSettings& settings, PixelSample sample,
                           double now, const View* next) {
    Session& s = session_;
    const FrameSize size = eye_size(s.stereo.mode, shown.room);
    const double distance = (s.viewpoint.camera.target - s.viewpoint.camera.eye).norm();
    const Area free = free_for_eye(s.stereo.mode, s.window.free, size);
    const View middle =
        scaled(view_of(s.viewpoint.camera, size.width, size.height, free), s.drawn.pace.scale);
    const std::vector<View> eyes = eye_views(middle, s.stereo.eyes, distance);
    pair_.fit(size);
    s.drawn.report = objects_.draw_eyes(eyes, settings, s.photos, sample, now, next, [&](std::size_t eye) {
        enlargement_.show(objects_, eyes[eye], shown, size, pair_.target(eye), false, eye);
    });
    drawn_view_ = eyes.front();
}

/// Shows what was drawn last.
void ShownScene::show(const RenderSettings& shown, double now) {
    if (stereo()) return pair_.show(session_.stereo.mode, shown.room, 0, true);
    if (is_final() && drawn_at_ != now && shown == last_settings_)
        enlargement_.show_again(objects_, *drawn_view_, shown, shown.room, 0, true);
    else
        enlargement_.show(objects_, *drawn_view_, shown, shown.room, 0, true);
}

/// Whether the samples of a picture at rest would keep the processor busy for too long: on a large screen, in
/// software, the picture stays as it is.
bool ShownScene::lacks_time(double now) const {
    constexpr double samples = 3;  // they take less time than the frame before, which also loaded tiles
    return now + samples * frame_ms_ / 1000 > changed_at_ + rest_seconds;
}

/// Whether the view differs from the last one, or a control is being dragged.
bool ShownScene::in_motion(const View& view) const {
    const bool dragged = ImGui::IsMouseDragging(0) && ImGui::IsAnyItemActive();
    return dragged || (last_ && !same_view(*last_, view));
}

/// Notes how long the frames took that are finished by now, and sets the pace of those to come.
void ShownScene::keep_pace() {
    const auto frame = clock_.take();
    if (!frame) return;
    note_time(session_.drawn, frame->ms);
    frame_ms_ = frame->ms;
    if (frame->pace != Pace{} || (pacing_.pace == Pace{} && pacing_.usual > 0)) {
        pacing_ = next_pacing(pacing_, frame->pace, frame->ms, goal_ms_);
        return;
    }
    // Frames at rest are slower than those in motion: if they are fast enough, so are these.
    const Pace first = first_pace(frame->ms, goal_ms_);
    if (pacing_.pace == Pace{} || first == Pace{} || first.scale > pacing_.pace.scale) pacing_ = {first};
}

/// Says once that frames of this size need more graphics memory than allowed.
void ShownScene::tell_memory(double now) {
    const std::uint64_t used = objects_.graphics_budget();
    if (memory_limit_ == 0 || used <= memory_limit_) return;
    say(session_.message,
        formatted(
            tr("Frames of this size need %.0f MiB of graphics memory, more than --graphics-memory allows"),
            double((used >> 20) + 1)),
        now);
    memory_limit_ = 0;
}

}  // namespace vantage
