#include "player/window/shown_scene.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/help_panel.h"
#include "player/interface/keyboard_navigation.h"
#include "player/interface/menu_bar.h"
#include "player/interface/message_line.h"
#include "player/interface/overlays/comparison.h"
#include "player/interface/overlays/frusta.h"
#include "player/interface/overlays/radar_panel.h"
#include "player/interface/overlays/surface_at_pixel.h"
#include "player/interface/sections/field_section.h"
#include "player/interface/sections/object_section.h"
#include "player/interface/sections/photo_list_section.h"
#include "player/interface/sections/picture_section.h"
#include "player/interface/sidebar.h"
#include "player/interface/state/failure_text.h"
#include "player/interface/tour/caption.h"
#include "player/interface/tour/visitor_bar.h"
#include "player/view/camera_path.h"
#include "player/window/input/numbered_file.h"
#include "player/window/input/view_clipboard.h"
#include "player/window/screenshot.h"

namespace vantage {

namespace {

/// Converts a pixel's position to another frame of the same view.
Eigen::Vector2d pixel_in(const Intrinsics& to, const Intrinsics& from, const Eigen::Vector2d& pixel) {
    return {pixel.x() * to.width / from.width, pixel.y() * to.height / from.height};
}

/// The folder where other packages are likely to be.
std::filesystem::path package_folder(const PackageReader& package) {
    return package.remote() ? std::filesystem::path(".") : package.path().parent_path();
}

}  // namespace

ShownScene::ShownScene(const PackageReader& package, const std::vector<SceneObject>& objects,
                       const ShowOptions& o, Session& session, Controls& controls)
    : scene_(package, objects, o, session),
      picture_(scene_, o, session),
      session_(session),
      controls_(controls),
      open_dialog_(package_folder(package)),
      story_editor_(scene_.renderer.scene().has_background()) {
    if (!o.window.kiosk) return;
    if (const std::string& trouble = scene_.active.trouble; !trouble.empty())
        std::fprintf(stderr, "%s\n", trouble.c_str());
    const StoryAttract attract = scene_.active.story.attract.value_or(StoryAttract{});
    const double home_after = o.window.home_after > 0 ? o.window.home_after : attract.after;
    kiosk_ = make_kiosk(session, kiosk_tour(package, o.window.tour), home_after);
}

/// The path given on the command line, or else the story's content.
std::optional<AttractLoop> ShownScene::kiosk_tour(const PackageReader& package,
                                                  const std::string& path) const {
    if (path.empty()) try {
            return attract_loop(scene_.active.story, session_.viewpoint.home, scene_.active.axes,
                                scene_.active.file.string());
        } catch (const Error& e) {  // the rest of the story can be shown
            std::fprintf(stderr, "%s\n", failure_text(tr("The tour cannot be played."), e).c_str());
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
    s.settings.points.pick =
        s.window.panels.expert && s.window.panels.points && scene_.renderer.resources().points;
    const RenderSettings shown = shown_settings();
    picture_.begin_frame();
    draw_picture(view, shown, now);
    if (s.settings.points.pick) pick(view);
    picture_.show(shown, now);
    while (take<SaveScreenshot>(s.window.commands))
        write_numbered(s.message, stem_for_files(scene_.package(), "", true), ".png",
                       tr_in("written", "screenshot"), now,
                       [&](const std::string& file) { save_frame(file, width, height); });
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    picture_.end_frame(now);
}

void ShownScene::draw_unseen(const View& view, double now) { draw_picture(view, shown_settings(), now); }

void ShownScene::draw_picture(const View& view, const RenderSettings& shown, double now) {
    picture_.draw(view, shown, now);
    if (lacks_thumbnails() && !picture_.drawn_at(now))
        scene_.renderer.planner().tiles().stream_thumbnails(shown.upload_bytes, now);
}

/// Requests the point of the cloud under the pointer.
void ShownScene::pick(const View& view) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const Eigen::Vector2d pixel(double(at.x), double(at.y));
    scene_.renderer.pick(pixel_in(picture_.drawn_view().intrinsics, view.intrinsics, pixel).cast<int>());
}

View ShownScene::update(int width, int height, double now) {
    Session& s = session_;
    if (kiosk_ && attend(*kiosk_, s, scene_.active, s.window.touched, now)) strip_.start_over();
    undo_.attend(s, scene_.active, scene_.measure, now);
    if (scene_.attend(s)) picture_.refine_again();
    use_clipboard(s, scene_.package(), now);
    const auto flight_end = end_of_flight(s.viewpoint);
    continue_flight(s.viewpoint, now, picture_.is_final());
    continue_tour(scene_.active, s.viewpoint, now);
    note_view(s.viewpoint, now);
    end_comparison_off_photo(s, scene_.plan(), now);
    s.window.tour = scene_.active.playing || (kiosk_ && kiosk_->tours);
    layout_ = layout_of(s.window.tour ? Panels{.bar = false, .photos = false} : s.window.panels, width,
                        height, double(ImGui::GetFontSize()), !scene_.plan().photos.empty());
    s.window.free = layout_.free;
    s.window.picture = picture_area_.update(layout_, s.settings.compare, {width, height}, flight_end, now);
    s.settings.capacity = {width, height};
    View view = shown_view(s.viewpoint.camera, s, scene_.plan(), width, height);
    shown_at_ = now;
    if (take_all<CloseMenus>(s.window.commands)) controls_.close_menus();
    interface(view, now);
    path_recorder_.attend(s, picture_.is_final(), scene_.package(), now);
    add_objects(now);
    scene_.asked_files.attend(s, scene_.package(), scene_.objects, now);
    orthophotos_.attend(s, scene_.package(), now);
    ImGui::Render();
    choose_projection(now);
    if (s.viewpoint.orthographic != (view.orthographic_depth > 0))  // changed by the interface
        return shown_view(s.viewpoint.camera, s, scene_.plan(), width, height);
    return view;
}

/// Switches from orthographic to perspective projection if the content requires that, which the interface may
/// just have changed.
void ShownScene::choose_projection(double now) {
    Session& s = session_;
    const bool points = scene_.renderer.resources().points && s.settings.points.show;
    if (!s.viewpoint.orthographic ||
        (!points && s.settings.compare == Compare::nothing && scene_.objects.size() == 1))
        return;
    s.viewpoint.orthographic = false;
    say(s.message,
        tr("Perspective restored: points, several objects and comparisons cannot be shown orthographically"),
        now);
}

/// The session's settings. Orthographic views and cuts disable the background, which would fill the part
/// removed by a cut.
RenderSettings ShownScene::shown_settings() const {
    RenderSettings settings = session_.settings;
    if (session_.viewpoint.orthographic || !settings.sections.empty())
        settings.background = ShowBackground::off;
    return settings;
}

/// A tour hides all panels.
void ShownScene::interface(const View& view, double now) {
    if (kiosk_ && kiosk_->tours) return invite(now);
    if (scene_.active.playing)
        tour_caption(now);
    else
        panels(view, now);
    if (picture_.drawn()) dialogs(now);
}

void ShownScene::panels(const View& view, double now) {
    Session& s = session_;
    if (s.window.panels.bar) visitor_bar(controls_, s, scene_.renderer, view, layout_.bar, now);
    if (!picture_.drawn()) return;  // the rest would delay the first picture
    const bool overlays = !picture_.in_parts();
    if ((s.window.panels.frusta || s.steering.inside) && overlays)
        frusta(s, scene_.renderer, strip_, view, now);
    pick_listed_point(s, scene_.plan(), view);
    const Intrinsics& frame = view.intrinsics;
    comparison(controls_, s, scene_.plan(), {0, 0, double(frame.width), double(frame.height)});
    false_color_legend(controls_, s, scene_.plan());
    if (overlays) unseen_legend_.show(controls_, s, scene_.plan(), scene_.renderer.planner().seen());
    if (s.window.panels.expert) {
        menu_bar(controls_, s, scene_.renderer, now);
        if (sidebar(controls_, s, {scene_.renderer, scene_.objects, view}, layout_.sidebar, now))
            picture_.refine_again();
    } else {
        field_legend_panel(controls_, s.settings.field, scene_.renderer, view, s.window.free);
    }
    if (overlays) lamp_handle(controls_, s);
    show_cut(view);
    scene_.measure.show(
        controls_, s,
        s.window.panels.measure && overlays ? scene_.objects.meshes() : std::vector<PlacedMesh>{}, view, now);
    if (s.window.panels.radar)
        radar_panel(controls_, s, scene_.renderer, view_of(s.viewpoint.camera, frame.width, frame.height),
                    now);
    if (layout_.strip.height > 0) strip_.show(controls_, s, scene_.renderer, view, layout_.strip, now);
    tell(view, now);
    if (s.window.panels.help) help_panel(controls_, s.window);
}

void ShownScene::dialogs(double now) {
    Session& s = session_;
    chooser_.attend(s.window.commands, s.message, package_folder(scene_.package()), now);
    open_dialog_.show(controls_, s.window);
    drop_dialog(controls_, s.window.commands, dropped_);
    unsaved_changes_.ask(controls_, s, scene_.active, scene_.measure, now);
    if (!s.window.tour) message_line(controls_, s.message, s.window, now);
    file_manager_.attend(s.window.commands, s.message, now);
    s.window.menu_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    note_navigation(s.window);
}

/// The note at whose stop the tour stands. On the way to the first stop, the tour's title.
void ShownScene::tour_caption(double now) {
    const ActiveStory& active = scene_.active;
    const auto show = [&](const StoryText& title, const std::string& text) {
        caption(controls_, text_in(active.story, title, active.language), text, session_.window.free);
    };
    const StoryTour& tour = active.story.tours[active.playing->tour];
    if (active.open) {
        const StoryNote& note = active.story.notes[*active.open];
        show(note.title, text_in(active.story, note.text, active.language));
    } else if (now < session_.viewpoint.flight->start + tour.stops.front().fly) {
        show(tour.title, kiosk_ ? tr("Touch to end the tour") : tr("Esc or a click ends the tour"));
    }
}

/// Invites visitors, and names the note at whose stop the tour stands.
void ShownScene::invite(double now) {
    const Story& story = scene_.active.story;
    const auto& flight = session_.viewpoint.flight;
    const std::optional<std::size_t> note =
        flight && flight->along ? note_at_stop(story, kiosk_->tour->tour, now - flight->start) : std::nullopt;
    caption(controls_, note ? text_in(story, story.notes[*note].title, scene_.active.language) : "",
            tr("Touch to begin"), session_.window.free);
}

/// Cuts the model with the session's planes, and draws the section.
void ShownScene::show_cut(const View& view) {
    Session& s = session_;
    const auto& planes = s.settings.sections = sections_of(s.cut, scene_.plan());
    const bool hidden = planes.empty() || picture_.in_parts();
    cut_lines_.show(hidden ? std::vector<PlacedMesh>{} : scene_.objects.meshes(), planes, view);
}

/// Shows notes, their cards and tours over the picture of `view`.
void ShownScene::tell(const View& view, double now) {
    Session& s = session_;
    const SeenTriangles seen = scene_.renderer.planner().seen();
    const SurfaceAt surface = [&](const Eigen::Vector2d& pixel) {
        return surface_at_pixel(scene_.plan(), seen, pixel_in(seen.view.intrinsics, view.intrinsics, pixel));
    };
    const std::vector<PlacedMesh> meshes = scene_.objects.meshes();
    SurfaceAt hit_surface = [&](const Eigen::Vector2d& pixel) {
        const auto hit = surface_on(meshes, ray_through(view, pixel), HUGE_VAL, s.settings.sections);
        return hit ? std::optional(hit->at) : std::nullopt;
    };
    if (meshes.empty() || picture_.in_parts()) hit_surface = {};
    const SurfaceAt anything = [&](const Eigen::Vector2d& pixel) {
        const auto on_model = hit_surface ? hit_surface(pixel) : std::nullopt;
        return on_model || picture_.in_parts() ? on_model : surface(pixel);
    };
    s.window.places_note &= s.window.panels.story_editor;
    s.window.hides_pieces &= s.window.panels.story_editor && !s.window.panels.measure;
    double room = s.window.free.height;
    if (s.window.panels.story_editor)
        room = story_editor_.show(controls_, scene_.active, s, view, {hit_surface, anything}, now);
    if (!s.window.panels.story || s.settings.compare != Compare::nothing) return;  // would cover the photo
    if (scene_.active.any() || (!scene_.active.trouble.empty() && !s.window.kiosk))
        story_panel(controls_, scene_.active, s, room, now);
    if (picture_.in_parts()) return;
    const MarkerInput input =
        draw_note_markers(controls_, note_markers(scene_.active.story, scene_.active.axes, view, surface),
                          scene_.active.story, scene_.active.language, scene_.active.open);
    if (input.clicked) open_note(scene_.active, s.viewpoint, *input.clicked, now);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (input.dragged && s.window.panels.story_editor && scene_.active.editable())
        place_note(scene_.active, *input.dragged, s, hit_surface, {double(mouse.x), double(mouse.y)});
    note_card(controls_, scene_.active, scene_.note_picture, s, now);
}

double ShownScene::wakes_at() const {
    double at = kiosk_ ? attends_at(*kiosk_) : HUGE_VAL;
    if (!session_.message.text.empty()) at = session_.message.shown ? session_.message.until : shown_at_;
    if (scene_.asked_files.busy() || scene_.note_picture.loading() || scene_.measure.saves())
        at = std::min(at, shown_at_ + 0.05);
    if (orthophotos_.writes() || chooser_.asks() || file_manager_.starts())
        at = std::min(at, shown_at_ + 0.5);
    at = std::min(at, picture_.looks_again_at());
    if (ImGui::GetIO().WantTextInput) at = std::min(at, shown_at_ + blink_seconds);
    if (layout_.strip.height > 0) at = std::min(at, strip_.ranks_at());
    if (lacks_thumbnails()) at = std::min(at, shown_at_ + 0.05);
    const auto traffic = scene_.package().traffic();
    if (traffic && traffic->bytes_per_second > 0) at = std::min(at, shown_at_ + 1);  // the status panel
    return at;
}

void ShownScene::stop_recording(double now) {
    session_.path.recording = false;
    path_recorder_.attend(session_, picture_.is_final(), scene_.package(), now);
}

/// Adds the packages that the session requests.
void ShownScene::add_objects(double now) {
    Session& s = session_;
    while (const auto added = take<AddObject>(s.window.commands)) try {
            scene_.objects.add({std::filesystem::path(added->file).stem().string(), added->file, {}, true});
            s.window.panels.objects = true;
            picture_.refine_again();
        } catch (const Error& e) {
            say(s.message,
                failure_text(formatted(tr("%s cannot be added."),
                                       std::filesystem::path(added->file).filename().c_str()),
                             e),
                now);
        }
}

}  // namespace vantage
