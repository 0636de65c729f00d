#include "player/headset/headset_scene.h"

#include <algorithm>
#include <utility>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/translation.h"
#include "player/interface/overlays/photo_frustum.h"
#include "player/interface/sections/cut_section.h"
#include "player/interface/tour/story_panel.h"
#include "player/options/frame_goal.h"
#include "player/render/timing/pace.h"
#include "player/survey/survey.h"
#include "player/survey/survey_file.h"
#include "player/tour/tour_stop.h"

namespace vantage {
namespace {

constexpr double arms_length = 1;  ///< distance to the target, in meters, in a scene of unknown size
constexpr double nearest = 0.05;   ///< near limit of overlays, meters

/// Meters per scene unit, from the command line or the scene's measurements; 0: unknown.
double unit_meters(const PackageReader& package, double given) {
    if (given > 0) return given;
    try {
        SurveyFile file = survey_file_of(package.path(), package.remote());
        const Scale scale = read_survey(file, {}).scale;
        return scale.unit == Unit::unknown ? 0 : scale.length * meters_in(scale.unit);
    } catch (const Error&) {  // the scene is shown without them
        return 0;
    }
}

}  // namespace

HeadsetScene::HeadsetScene(const PackageReader& package, const std::vector<SceneObject>& objects,
                           const ShowOptions& o, Session& session)
    : scene_(package, objects, o, session),
      session_(session),
      origin_(Eigen::Map<const Eigen::Vector3d>(package.scene().origin)),
      up_(up_of(package.scene())),
      unit_meters_(unit_meters(package, o.headset.unit_meters)),
      fps_(o.window.fps),
      controls_(o.window.controls),
      clock_(gl::current_device().software) {
    session_.window.keyboard = false;
    session_.window.panels.measure = false;  // a page of the menu
}

/// Places the head at the session's camera.
void HeadsetScene::place(const RoomPose& head) {
    const Navigation& at = session_.viewpoint.home;
    const double distance = (at.target - at.eye).norm();
    locomotion_.usual_scale = unit_meters_ > 0 ? 1 / unit_meters_ : std::max(distance, 1e-9) / arms_length;
    locomotion_.stance = standing(head, at.eye, at.target, up_, locomotion_.usual_scale);
}

/// Moves the session's camera to the head, for panels that depend on the viewer's position.
void HeadsetScene::follow_head(const HeadsetFrame& frame) {
    const View middle = view_of_eye(locomotion_.stance, {frame.head}, {1, 1});
    session_.viewpoint.camera = stand_at(middle, up_, locomotion_.stance.scale);
}

/// If there is no menu button, selecting with both hands opens and closes the menu.
void HeadsetScene::take_menu_button(const HeadsetFrame& frame) {
    const auto& [left, right] = frame.hands;
    const bool both = !left.has_menu && !right.has_menu && left.select && right.select;
    if (both) let_go(locomotion_);
    const bool pressed = left.menu || right.menu || both;
    if (pressed && !menu_pressed_) menu_ = menu_ ? std::nullopt : std::optional(menu_in_front_of(frame.head));
    menu_pressed_ = pressed;
}

void HeadsetScene::place_panel() {
    panel_.reset();
    if (menu_) panel_ = menu_panel(*menu_, locomotion_.stance, SceneInterface::width, SceneInterface::height);
}

void HeadsetScene::point(const HeadsetFrame& frame) {
    place_panel();
    const std::vector<PlacedMesh> meshes = scene_.objects.meshes();
    const PointingTargets targets{panel_, meshes, origin_, scene_.active.story, scene_.plan(), session_};
    for (std::size_t i = 0; i < 2; ++i) pointed_[i] = pointed_by(frame.hands[i], locomotion_.stance, targets);
    menu_pointer_ =
        next_menu_pointer(menu_pointer_, frame.hands, pointed_, selected_, locomotion_.stance, panel_);
}

/// Whether a hand has just selected its target.
bool HeadsetScene::chosen(const Hands& hands, std::size_t hand) const {
    return hands[hand].select && !selected_[hand] && !pointed_[hand].menu;
}

void HeadsetScene::act(const HeadsetFrame& frame) {
    const double now = frame.time;
    for (std::size_t i = 0; i < 2; ++i) {
        const Pointed& p = pointed_[i];
        if (session_.window.panels.measure && frame.hands[i].aim && !p.menu)
            scene_.measure.point_at(p.surface);
        if (!chosen(frame.hands, i)) continue;
        if (session_.window.panels.measure)
            scene_.measure.set_point(session_, now);
        else if (p.note)
            scene_.active.playing.reset(), scene_.active.open = *p.note, page_ = MenuPage::story;
        else if (p.photo)
            fly_to(session_, *p.photo, scene_.plan().photos[*p.photo], now);
        if (p.note && !menu_) menu_ = menu_in_front_of(frame.head);
    }
}

FreeHands HeadsetScene::free_hands() const {
    FreeHands out;
    for (std::size_t i = 0; i < 2; ++i) {
        const Pointed& p = pointed_[i];
        out[i].move = !p.menu && menu_pointer_.hand != i;
        out[i].select = !p.photo && !p.note && !session_.window.panels.measure;
    }
    return out;
}

void HeadsetScene::move(const HeadsetFrame& frame, double seconds) {
    if (std::exchange(gazed_, frame.gazes) != frame.gazes || !frame.focused) let_go(locomotion_);
    const std::vector<PlacedMesh> meshes = scene_.objects.meshes();
    const SurfaceBetween surface = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        return surface_on(meshes, {from, to - from}, 1, session_.settings.sections);
    };
    if (menu_) {
        const auto pointing =
            menu_pointer_.hand && pointed_[*menu_pointer_.hand].menu ? menu_pointer_.hand : std::nullopt;
        carry(*menu_, frame.hands, pointing);
    }
    Hands hands = frame.hands;
    if (menu_pointer_.hand) hands[*menu_pointer_.hand].stick.setZero();  // it scrolls
    continue_locomotion(locomotion_, hands, free_hands(), frame.head, seconds, surface);
}

/// Jumps to a tour's stop when the window would start flying there. Locomotion ends the tour.
void HeadsetScene::stand_at_stop(const HeadsetFrame& frame) {
    const Viewpoint::Flight& flight = *session_.viewpoint.flight;
    const double seconds = frame.time - scene_.active.playing->start;
    const TourStop to = tour_stop(scene_.active.story.tours[scene_.active.playing->tour], seconds);
    const bool there = stop_ && stop_->number == to.stop && stop_->started == scene_.active.playing->start;
    if (there && locomotion_.stance.at != stop_->stood.at) return session_.viewpoint.flight.reset();
    if (there) return;
    const Navigation camera = flight.along->at(to.reached);
    locomotion_.stance = standing(frame.head, camera.eye, camera.target, up_, locomotion_.stance.scale);
    stop_ = Stop{to.stop, scene_.active.playing->start, locomotion_.stance};
}

/// Shows the note opened by a tour.
void HeadsetScene::continue_tour(const HeadsetFrame& frame) {
    if (!scene_.active.playing) return stop_.reset();
    if (session_.viewpoint.flight &&
        frame.time - scene_.active.playing->start >= session_.viewpoint.flight->seconds)
        session_.viewpoint.flight.reset();
    const auto before = scene_.active.open;
    vantage::continue_tour(scene_.active, session_.viewpoint, frame.time);
    if (!scene_.active.open || scene_.active.open == before) return;
    page_ = MenuPage::story;
    if (!menu_) menu_ = menu_in_front_of(frame.head);
}

/// Replaces the window's flights with jumps, because involuntary motion causes sickness.
void HeadsetScene::stand_where_sent(const HeadsetFrame& frame) {
    if (!session_.viewpoint.flight) return;
    if (session_.viewpoint.flight->along)
        return scene_.active.playing ? stand_at_stop(frame) : session_.viewpoint.flight.reset();
    const Navigation to = session_.viewpoint.flight->stops.back();
    session_.viewpoint.flight.reset();
    locomotion_.stance = standing(frame.head, to.eye, to.target, up_, locomotion_.stance.scale);
}

std::vector<SceneLabel> HeadsetScene::labels(const HeadsetFrame& frame) const {
    std::vector<SceneLabel> out;
    const std::array<float, 4> white{1, 1, 1, 1};
    if (!session_.message.text.empty()) {
        const Eigen::Vector3d ahead = frame.head.ahead() + Eigen::Vector3d(0, -0.25, 0);
        out.push_back(
            {session_.message.text, in_scene(locomotion_.stance, frame.head.at + ahead), white, true});
    }
    if (session_.window.panels.measure)
        for (const DrawnMeasurement& d : measured_) {
            const std::vector<Eigen::Vector3d> points = points_from(d.measurement, origin_);
            if (points.empty() || d.label.empty()) continue;
            out.push_back({d.label, label_place(d.measurement.measure, points, scene_.measure.up()), white});
        }
    for (std::size_t i = 0; i < scene_.active.story.notes.size(); ++i)
        if (const auto& anchor = scene_.active.story.notes[i].anchor;
            anchor && !hides(scene_.active.story, *anchor))
            out.push_back({note_label(scene_.active, i), *anchor - origin_, white});
    for (const Pointed& p : pointed_)
        if (p.photo)
            out.push_back({scene_.plan().photos[*p.photo].name,
                           photo_frustum(scene_.plan(), *p.photo).corner[1], white});
    const bool hidden_menu = session_.window.panels.measure && !menu_;
    for (const Hand& hand : frame.hands)
        if (hidden_menu && hand.grip)
            out.push_back({tr("Measure"), in_scene(locomotion_.stance, hand.grip->at), white});
    return out;
}

void HeadsetScene::write_interface(const HeadsetFrame& frame, double seconds) {
    if (frame.time > session_.message.until) session_.message.text.clear();
    scene_.attend(session_);
    interface_.begin(menu_pointer_.pointer, seconds);
    continue_tour(frame);
    measured_.clear();
    if (scene_.measure.attend(session_, frame.time)) measured_ = scene_.measure.drawn();
    const MenuContent content{scene_, page_, locomotion_, unit_meters_, dims_edges_};
    if (menu_)
        headset_menu(interface_.controls(), session_, content,
                     {SceneInterface::width, SceneInterface::height}, frame.time);
    interface_.end(labels(frame), view_of_eye(locomotion_.stance, {frame.head}, {1, 1}));
    scene_.asked_files.attend(session_, scene_.package(), scene_.objects, frame.time);
    if (!controls_.empty()) interface_.controls().write_places(controls_);
}

void HeadsetScene::mark(const HeadsetFrame& frame) {
    clear(marks_);
    clear(hand_marks_);
    const Eigen::Vector3d eye = in_scene(locomotion_.stance, frame.head.at);
    std::optional<std::uint32_t> photo;
    for (const Pointed& p : pointed_)
        if (p.photo) photo = p.photo;
    if (session_.window.panels.frusta)
        add_photos(marks_, locomotion_.stance, scene_.renderer, session_, eye, photo);
    if (session_.window.panels.measure)
        for (const DrawnMeasurement& d : measured_)
            add_measurement(marks_, locomotion_.stance, d, origin_, scene_.measure.up());
    for (std::size_t i = 0; i < scene_.active.story.notes.size(); ++i)
        if (const auto& anchor = scene_.active.story.notes[i].anchor;
            anchor && !hides(scene_.active.story, *anchor))
            add_note(marks_, locomotion_.stance, *anchor - origin_, scene_.active.open == i);
    if (locomotion_.arc) add_arc(marks_, locomotion_.stance, *locomotion_.arc);
    for (std::size_t i = 0; i < 2; ++i) {
        Hand hand = frame.hands[i];
        const Pointed& p = pointed_[i];
        if (locomotion_.aiming == i) hand.aim.reset();  // its ray is the arc
        if (!frame.gazes)
            add_hand(hand_marks_, locomotion_.stance, hand, p.length, p.any());
        else if (hand.aim && p.any())  // a ray from between the eyes would obstruct the view
            add_dot(hand_marks_, locomotion_.stance, hand, p.length);
    }
    mark_pass_.upload(marks_);
    hand_pass_.upload(hand_marks_);
}

std::array<View, 2> HeadsetScene::views_of(const HeadsetFrame& frame, FrameSize size) const {
    const auto view = [&](std::size_t eye) {
        return scaled(view_of_eye(locomotion_.stance, frame.eyes[eye], size), session_.drawn.pace.scale);
    };
    return {view(0), view(1)};
}

void HeadsetScene::frame(HeadsetSession& headset, const HeadsetFrame& frame,
                         const std::function<void(GLuint, FrameSize)>& seen) {
    if (frame.shown) headset.take_pictures();  // waiting for the runtime does not count as frame time
    clock_.begin();
    drawn_.clear();
    if (frame.shown) {
        goal_ms_ = fps_ < 0 ? 1000 * frame.period : frame_goal(fps_);
        const double seconds = frame.time - std::exchange(time_, frame.time);
        if (!std::exchange(placed_, true)) place(frame.head);
        follow_head(frame);
        take_menu_button(frame);
        point(frame);
        act(frame);
        for (std::size_t i = 0; i < 2; ++i)
            if (frame.hands[i].select && !selected_[i] && pointed_[i].any()) headset.hands().buzz(i);
        move(frame, seconds);
        write_interface(frame, seconds);
        stand_where_sent(frame);
        place_panel();  // it has moved with the room
        mark(frame);
        for (std::size_t i = 0; i < 2; ++i) selected_[i] = frame.hands[i].select;
        draw(headset, frame, seen);
    }
    clock_.end(frame.shown ? std::optional(session_.drawn.pace) : std::nullopt);
    headset.end_frame(drawn_);
    keep_pace();
}

void HeadsetScene::draw(HeadsetSession& headset, const HeadsetFrame& frame,
                        const std::function<void(GLuint, FrameSize)>& seen) {
    Session& s = session_;
    s.drawn.pace = pacing_.pace;
    s.settings.image_sets.how = ImageSetView::mix;  // a divided picture would differ between the eyes
    s.settings.sections = sections_of(s.cut, scene_.plan());
    RenderSettings settings = s.settings;
    settings.capacity = headset.size(0);
    settings.reduced = s.drawn.pace.reduced;
    if (!settings.sections.empty()) settings.background = ShowBackground::off;
    const std::array<View, 2> views = views_of(frame, headset.size(0));
    s.drawn.report =
        scene_.objects.draw_eyes({views, settings, s.photos, {}, frame.time}, [&](std::size_t eye) {
            const GLuint target = headset.color_target(eye);
            scene_.objects.show(views[eye], settings, {target, true, eye});
            const FrameSize size = frame_size(views[eye]);
            const DrawnDepth depth = scene_.objects.depth(settings, nearest * locomotion_.stance.scale);
            draw_over(views[eye], depth, target);
            if (eye == 0) seen(target, size);
            drawn_.push_back({size, depth_of(headset, depth, size, eye)});
        });
}

/// Draws overlays. The menu and the hands are never occluded.
void HeadsetScene::draw_over(const View& view, const DrawnDepth& depth, GLuint target) {
    if (dims_edges_) vignette_.draw(view, target, locomotion_.vignette);
    EyePicture eye{view, nearest * locomotion_.stance.scale, target, true};
    EyePicture behind_model = eye;
    behind_model.depth = {depth.texture, depth.terms, frame_size(view)};
    mark_pass_.draw(behind_model);
    interface_.draw_labels(behind_model);
    if (panel_) interface_.draw_menu(*panel_, eye);
    hand_pass_.draw(eye);
}

std::optional<DepthLimits> HeadsetScene::depth_of(HeadsetSession& headset, const DrawnDepth& depth,
                                                  FrameSize size, std::size_t eye) {
    if (!headset.takes_depth()) return {};
    return depth_.copy(depth, size, locomotion_.stance.scale, headset.depth_target(eye));
}

/// Adapts the pace of later frames to the durations of finished frames.
void HeadsetScene::keep_pace() {
    const auto frame = clock_.take();
    if (!frame) return;
    note_time(session_.drawn, frame->ms);
    if (goal_ms_ <= 0) return;
    pacing_ = next_pacing(pacing_, frame->pace, frame->ms, goal_ms_);
}

}  // namespace vantage
