#include "player/render/renderer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/values/tiling.h"
#include "player/render/passes/blend_table.h"
#include "player/render/passes/full_frame_program.h"

namespace vantage {
namespace {

static_assert(GLuint(Compare::nothing) == shader::compare_nothing &&
              GLuint(Compare::side_by_side) == shader::compare_side_by_side &&
              GLuint(Compare::swipe) == shader::compare_swipe &&
              GLuint(Compare::difference) == shader::compare_difference);

constexpr float dimmed_light = 0.2f;  ///< of the dimmed background

/// a and b, where depth is a + b / z.
Eigen::Vector2d terms_of(const View& view, const Eigen::Vector2d& range) {
    const Eigen::Matrix4d clip = clip_from_cam(view.intrinsics, range.x(), range.y());
    return {clip(2, 2), clip(2, 3)};
}

/// While it lives, nothing is cleared or drawn outside of the frame: its targets may be much larger.
class DrawnRegion {
  public:
    explicit DrawnRegion(const FrameTargets& targets) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, targets.width, targets.height);
    }
    ~DrawnRegion() { glDisable(GL_SCISSOR_TEST); }
    DrawnRegion(const DrawnRegion&) = delete;
    DrawnRegion& operator=(const DrawnRegion&) = delete;
};

/// 1 where photos were taken, 0 farther from all of them than they are spread: in between, one may have left
/// the background in one direction while still inside in others.
double nearness_to_photos(const PlanScene& scene, const Eigen::Vector3d& eye) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.poses.size(); ++i)
        if (scene.photos[i].image_set == 0)
            nearest = std::min(nearest, (scene.poses[i].center() - eye).norm());
    return scene.spread > 0 ? std::clamp(2 - nearest / scene.spread, 0.0, 1.0) : 0;
}

/// Bytes for the tiles that a frame of this size shows, plus some shown earlier.
std::uint64_t tiles_for(int width, int height) {
    constexpr double MiB = 1 << 20;
    return std::uint64_t(std::clamp(256 * MiB * width * height / (1280.0 * 720), 256 * MiB, 1024 * MiB));
}

/// Bytes for points: a quarter of a limit that was given.
std::uint64_t points_memory(const MemoryBudget& budget) {
    return budget.graphics ? std::min(PointStore::max_bytes, budget.graphics / 4) : PointStore::max_bytes;
}

/// The view shifted so that its pixel centers are the positions of one sample.
View sampled(View view, PixelSample s) {
    view.intrinsics.cx -= (s.index % s.side + 0.5) / s.side - 0.5;
    view.intrinsics.cy -= (s.index / s.side + 0.5) / s.side - 0.5;
    return view;
}

/// Keeps non-finite values, and values whose square overflows single precision, from the shaders. Throws
/// Error(usage).
void check_view(const View& view) {
    const Intrinsics& k = view.intrinsics;
    const Pose& pose = view.cam_from_origin;
    const bool turns = (pose.R * pose.R.transpose()).isIdentity(1e-3);
    const bool stands = pose.t.norm() < 1e18;
    const bool lens = k.fx > 0 && k.fy > 0 && std::isfinite(float(k.fx) + float(k.fy)) &&
                      std::isfinite(float(k.cx) + float(k.cy));
    if (k.width < 1 || k.height < 1)
        throw Error(Exit::usage, "a picture of " + std::to_string(k.width) + "x" + std::to_string(k.height) +
                                     ", expected at least 1x1");
    if (!turns || !stands || !lens)
        throw Error(Exit::usage, "a view's position, direction or field of view is not finite");
}

/// Points and background is drawn for perspective only. Throws Error(usage).
void expect_perspective(const View& view, bool points, bool background) {
    if (view.orthographic_depth > 0 && (points || background))
        throw Error(Exit::usage, "an orthographic view shows neither points nor background");
}

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

gl::Program make_show_program(const PackageReader& package, const PlanScene& scene) {
    std::vector<std::string> defines = background_defines(scene);
    if (scene.has_transparency()) defines.emplace_back("TRANSPARENCY");
    if (effect_on(package.scene(), Effect::undistortion)) defines.emplace_back("PHOTO_LENS");
    for (std::string& d : shader_defines("show", package.scene().effects)) defines.push_back(std::move(d));
    return full_frame_program("show", "show.frag", defines);
}

}  // namespace

Renderer::Renderer(const PackageReader& package, const MemoryBudget& budget)
    : package_(&package),
      budget_(budget),
      scene_(make_plan_scene(package)),
      // In software, a frame's uploads are done when the next one begins.
      store_(package, gl::current_device().software ? budget.ring / 2 : budget.ring),
      passes_(package, scene_, store_),
      tiles_(scene_, store_, passes_),
      resolve_program_(make_resolve_program({})),
      show_program_(make_show_program(package, scene_)),
      no_vertices_(gl::make_vertex_array("no vertices")) {
    eyes_.emplace_back(scene_);
    if (scene_.has_background()) filling_.emplace();
    if (auto cloud = read_point_cloud(package))
        points_.emplace(package, std::move(*cloud), points_memory(budget));
    if (scene_.has_transparency())
        transparent_.emplace(budget.graphics ? budget.graphics / 4 : TransparentPass::max_list_bytes);
    held_ = gl::memory_held() - held_;
    gl::check("opening the package");
}

void Renderer::set_budget(const MemoryBudget& budget) {
    if (budget.graphics != budget_.graphics) targets_ = {};  // it has to be divided again
    budget_ = budget;
}

gl::Program Renderer::make_resolve_program(const std::vector<std::string>& asked) const {
    std::vector<std::string> defines = background_defines(scene_);
    for (std::string& d : shader_defines("resolve", package_->scene().effects))
        defines.push_back(std::move(d));
    defines.insert(defines.end(), asked.begin(), asked.end());
    return full_frame_program("resolve", "resolve.frag", defines);
}

const gl::Program& Renderer::resolve_program(const RenderSettings& settings) {
    std::vector<std::string> asked = passes_.asked_defines(settings);
    if (settings.light.wireframe) asked.emplace_back("WIREFRAME");
    if (transparent_ && transparent_->mode() == Transparency::exact) asked.emplace_back("FRAGMENT_LISTS");
    if (asked.empty()) return resolve_program_;
    gl::Program& program = other_resolve_programs_[asked];
    if (!program) program = make_resolve_program(asked);
    return program;
}

/// In a scene of points only there is nothing but points, and no surface to put light or layers on.
RenderSettings Renderer::usable(RenderSettings settings) const {
    if (!points_ || !points_only(package_->scene())) return settings;
    settings.points.show = settings.points.alone = true;
    settings.light.light = Light::photos;
    settings.layer.layer = -1;
    return settings;
}

bool Renderer::photos_on_points(const RenderSettings& settings) const {
    const PointColor color = settings.points.color;
    return points_ && !scene_.photos.empty() &&
           (color == PointColor::photos ||
            (color == PointColor::automatic && points_only(package_->scene())));
}

/// Creates targets with room for the frame, and fits the tiles into the rest of the budget.
void Renderer::fit(FrameSize frame, std::span<const ImageSetFrame> image_sets) {
    const RenderSettings& settings = image_sets.front().settings;
    const FrameSize room = room_for(frame, settings.room);
    const auto [width, height] = room;
    const bool coordinates =
        std::ranges::any_of(image_sets, [&](const ImageSetFrame& b) { return !per_fragment(b.settings); });
    const bool placed = points_ && (photos_on_points(settings) || settings.points.pick);
    const bool veiled = transparent_ && settings.transparency != Transparency::off && scene_.has_background();
    const std::size_t eyes = eyes_.size();
    const std::size_t surfaces = may_have_own_surfaces(settings) ? eyes : 1;
    // A first picture, which may be coarse, does not wait for the memory of those that follow.
    const FrameSize made = settings.wait_for_base ? frame : room;
    const bool fits = targets_.room == made && targets_.samples.size() == eyes &&
                      targets_.surfaces.size() >= surfaces && (store_.has_coordinates() || !coordinates) &&
                      (!points_ || points_->placed() || !placed) &&
                      (!transparent_ || transparent_->mode() == settings.transparency);
    if (!fits) {
        targets_ = {};
        for (Eye& eye : eyes_) eye.readback.release();
        if (points_) points_->release();
        if (transparent_) transparent_->release();
        const std::uint64_t others =
            gl::memory_held() - budget_.elsewhere - store_.bytes() +
            FrameTargets::bytes(room, eyes, surfaces) +
            (scene_.image_sets.size() > 1 ? eyes * PictureSamples::bytes(width, height) : 0) +
            (veiled ? eyes * PictureSamples::veil_bytes(width, height) : 0) +
            (filling_ ? HoleFilling::bytes(width, height) : 0) +
            (points_ ? PointPass::bytes(width, height, placed) + points_->growth() : 0) +
            (transparent_ ? transparent_->bytes(width, height, settings.transparency) : 0) +
            eyes * TriangleReadback::bytes(width, height);
        graphics_budget_ = budget_.graphics ? budget_.graphics : others + tiles_for(width, height);
        store_.fit(graphics_budget_ > others ? graphics_budget_ - others : 0, coordinates);
        graphics_budget_ = std::max(graphics_budget_, others + store_.residency().layout().bytes());
        targets_ = make_frame_targets(made, eyes, surfaces);
        if (filling_) filling_->fit(made.width, made.height);
        if (points_) points_->fit(targets_, placed);
        if (transparent_) transparent_->fit(targets_, settings.transparency);
    }
    targets_.width = frame.width, targets_.height = frame.height;
    targets_.surface_number = 0;
    for (PictureSamples& samples : targets_.samples) {
        if (image_sets.size() > 1) samples.add_other();
        if (veiled) samples.add_veil();
    }
}

void Renderer::coarsen(bool wait) {
    if (coarse_triangles(scene_) == 0) return;
    if (!coarsening_) coarsening_.emplace(scene_);
    if (auto mesh = coarsening_->take(wait)) passes_.use_coarse(std::move(*mesh));
}

bool Renderer::take_seen(Eye& eye, bool wait) {
    return eye.readback.update(wait, scene_.triangles, passes_.coarse().stands_for);
}

/// Plans the image sets of an eye. In a frame that does not wait for all tiles, those of the first eye serve
/// both: the second one's plan has its photos, and no tiles of its own.
void Renderer::plan_eye(Eye& eye, PixelSample sample) {
    for (std::size_t b = 0; b < eye.image_sets.size(); ++b) {
        const ImageSetFrame& image_set = eye.image_sets[b];
        const RenderSettings& settings = image_set.settings;
        PlanSettings how = plan_settings(settings);
        if (settings.complete && reads_seen(how) && sample.index == 0) find_seen(eye, image_set, sample);
        const PhotoChoice* photos = nullptr;
        if (&eye != &eyes_[0] && !settings.complete) {
            photos = &eyes_[0].image_sets.at(b).plan->plan().choice;
            how.tiles = false;
        }
        const bool both = !settings.complete && eyes_.size() > 1;
        image_set.plan->update(eye.view, how, image_set.photos, sample.side,
                               both ? seen_by_both(eye) : eye.readback.seen(), photos);
    }
}

/// What the eyes saw, as if this one had seen it all.
SeenTriangles Renderer::seen_by_both(const Eye& eye) {
    const SeenTriangles left = eyes_[0].readback.seen(), right = eyes_[1].readback.seen();
    if (const std::uint64_t version = left.version + right.version; version != seen_version_) {
        seen_version_ = version;
        seen_by_both_.assign(left.triangles.begin(), left.triangles.end());
        seen_by_both_.insert(seen_by_both_.end(), right.triangles.begin(), right.triangles.end());
    }
    return {seen_by_both_, eye.readback.seen().view, seen_version_};
}

void Renderer::stream_points(const Eye& eye, FrameReport& report) {
    const RenderSettings& settings = eye.image_sets.front().settings;
    if (!shows_points(settings)) return;
    report.uploaded += points_->stream(eye.view, settings, sample_.side, now_);
    report.nodes_missing += points_->missing();
}

FrameReport Renderer::draw(const View& view, const RenderSettings& settings,
                           std::span<const std::uint32_t> photos, PixelSample sample, double now,
                           const View* next) {
    FrameReport report = prepare({&view, 1}, settings, photos, sample, now, next);
    paint(0, report);
    return report;
}

FrameReport Renderer::prepare(std::span<const View> views, const RenderSettings& given,
                              std::span<const std::uint32_t> photos, PixelSample sample, double now,
                              const View* next) {
    for (const View& view : views) check_view(view);
    const std::uint64_t held_before = gl::memory_held();
    const RenderSettings settings = usable(given);
    expect_perspective(views.front(), shows_points(settings), passes_.shows_background(settings));
    if (!shows_photos(settings)) photos = {};
    if (settings.weights_from) check_view(*settings.weights_from);
    sample_ = sample, now_ = now;
    if (eyes_.size() != views.size()) seen_version_ = 0;
    while (eyes_.size() > views.size()) eyes_.pop_back();
    while (eyes_.size() < views.size()) eyes_.emplace_back(scene_);
    std::vector<ImageSetFrame> image_sets;  // of all eyes
    for (std::size_t i = 0; i < views.size(); ++i) {
        Eye& eye = eyes_[i];
        eye.view = views[i];
        eye.sampled = sampled(views[i], sample);
        eye.prepared.reset();
        eye.has_surface = false;
        if (i == 0)
            eye.plans.choose(settings, now);
        else
            eye.plans.follow(eyes_[0].plans);  // else one eye might fade while the other has done so
        eye.image_sets = eye.plans.frames(settings, photos);
        image_sets.insert(image_sets.end(), eye.image_sets.begin(), eye.image_sets.end());
    }
    if (passes_.load_layer(settings)) targets_ = {};  // the budget has to be divided again
    fit(frame_size(views.front()), eyes_[0].image_sets);
    const DrawnRegion region(targets_);
    // What a frame waits for, it shows.
    const bool fades = !settings.complete && !settings.wait_for_tiles && !settings.wait_for_uploads;
    store_.begin_frame(now, fades);
    FrameReport report;
    if (!settings.complete)
        for (Eye& eye : eyes_) take_seen(eye, settings.wait_for_tiles);
    const auto planning = std::chrono::steady_clock::now();
    for (Eye& eye : eyes_) plan_eye(eye, sample);
    report.plan_ms = milliseconds_since(planning);
    stream_points(eyes_[0], report);
    report.clusters = plan().clusters.size();
    report.uncovered = plan().uncovered;
    const View* ahead = settings.swift ? nullptr : next;
    if (!settings.complete) tiles_.stream(eyes_[0].sampled, image_sets, sample.side, ahead, report);
    for (const ImageSetFrame& image_set : image_sets)
        image_set.plan->fade(plan_settings(image_set.settings), now,
                             tiles_.ready_photos(image_set.settings, image_set.plan->plan()));
    prepare_surfaces();
    held_ += gl::memory_held() - held_before;
    return report;
}

/// Points and transparent surfaces share the depth of one surface, and two image sets may differ in theirs.
EyeSurfaces Renderer::eye_surfaces() const {
    const std::vector<ImageSetFrame>& image_sets = eyes_[0].image_sets;
    const RenderSettings& settings = image_sets.front().settings;
    const bool own = image_sets.size() == 1 && !shows_points(settings) && may_have_own_surfaces(settings);
    return own ? passes_.eye_surfaces(settings) : EyeSurfaces::in_turn;
}

/// What is shown for a while only does not decide, because new targets take the place of tiles.
bool Renderer::may_have_own_surfaces(const RenderSettings& settings) const {
    const bool transparent = transparent_ && settings.transparency != Transparency::off;
    return eyes_.size() == 2 && !transparent && !points_only(package_->scene()) &&
           passes_.eye_surfaces(settings) != EyeSurfaces::in_turn;
}

void Renderer::prepare_surfaces() {
    coarse_ = std::ranges::all_of(eyes_, [&](const Eye& eye) {
        const ImageSetFrame& image_set = eye.image_sets.front();
        return passes_.suits_coarse(eye.sampled, image_set.settings, image_set.plan->plan());
    });
    surfaces_ = eye_surfaces();
    if (surfaces_ == EyeSurfaces::in_turn) return;
    for (Eye& eye : eyes_) eye.prepared.emplace(drawn_view(eye));
    if (surfaces_ != EyeSurfaces::at_once) return;
    passes_.draw_surfaces(*eyes_[0].prepared, *eyes_[1].prepared, targets_);
    for (Eye& eye : eyes_) eye.has_surface = true;
}

void Renderer::paint(std::size_t number, FrameReport& report) {
    const std::uint64_t held_before = gl::memory_held();
    Eye& eye = eyes_[number];
    const RenderSettings& settings = eye.image_sets.front().settings;
    const DrawnRegion region(targets_);
    if (number > 0) stream_points(eye, report);
    Frame frame{eye.prepared ? std::move(*eye.prepared) : drawn_view(eye), sample_, now_, report, number};
    eye.prepared.reset();
    depth_terms_ = terms_of(eye.sampled, frame.drawn.depth_range);
    draw_surface(number, frame.drawn);
    eye.has_surface = false;  // once it is painted, it may be drawn over
    if (!settings.complete) eye.readback.capture(targets_, eye.view);
    draw_present(frame);
    for (const ImageSetFrame& image_set : std::span(eye.image_sets).subspan(1)) {
        Frame second{
            drawn_view(eye.sampled, image_set, sample_.side, coarse_), sample_, now_, {}, number, true};
        draw_image_set(second);
        frame.report = joined(frame.report, second.report);
    }
    count_fragments(frame);
    FrameReport& r = frame.report;
    r.fragments = fragments_.fragments, r.fragments_approximated = fragments_.approximated;
    r.tiles_damaged = store_.residency().damaged_count() + (points_ ? points_->damaged() : 0);
    r.tiles_absent = store_.residency().absent_count() + (points_ ? points_->absent() : 0);
    const bool planned = std::ranges::all_of(eyes_, [](const Eye& e) { return e.plans.settled(); });
    r.settled = r.tiles_to_come == 0 && r.nodes_missing == 0 && planned && store_.residency().settled();
    if (settings.swift ? !settings.wait_for_base : r.settled && !settings.complete) coarsen(false);
    held_ += gl::memory_held() - held_before;
    gl::check("rendering a view");
    report = r;
}

/// The bare surface that an eye sees, unless it has been drawn.
void Renderer::draw_surface(std::size_t number, const DrawnView& drawn) {
    Eye& eye = eyes_[number];
    targets_.surface_number = surfaces_ == EyeSurfaces::in_turn ? 0 : number;
    if (!eye.has_surface) passes_.draw_surface(drawn, targets_);
    eye.has_surface = true;
}

/// A software rasterizer prepares triangles on one thread, while others can blend an eye's photos.
void Renderer::draw_next_surface(std::size_t number) {
    const std::size_t next = number + 1;
    if (next >= eyes_.size() || !eyes_[next].prepared) return;
    draw_surface(next, *eyes_[next].prepared);
    targets_.surface_number = number;
}

std::string Renderer::failure() const {
    const std::string of_points = points_ ? points_->failure() : std::string();
    return of_points.empty() ? store_.failure() : of_points;
}

/// A second image set, or one again: with its own surface, because it may lack background.
void Renderer::draw_image_set(Frame& frame) {
    passes_.draw_surface(frame.drawn, targets_);
    draw_present(frame);
}

void Renderer::redraw(const View& view, const RenderSettings& given) {
    check_view(view);
    const RenderSettings settings = usable(given);
    if (settings.weights_from) check_view(*settings.weights_from);
    targets_.surface_number = 0;
    for (const ImageSetFrame& image_set : eyes_[0].plans.frames(settings, {})) {
        Frame frame{drawn_view(view, image_set, 1, coarse_), {}, 0, {}, 0, image_set.second};
        draw_image_set(frame);
    }
    gl::check("rendering a view again");
}

/// Draws the photos on the surface drawn; during a transition also those that they replace.
void Renderer::draw_present(Frame& frame) {
    const ViewPlan& plan = frame.drawn.plan;
    const std::vector<const PlannedPhoto*> drawn = plan.drawn();
    frame.report.photos = drawn.size();
    // Points that photos are drawn on come first: their depth keeps photos off the model behind them.
    const bool shows = shows_points(frame.drawn.settings), first = photos_on_points(frame.drawn.settings);
    if (shows && first) draw_points(frame);
    if (!plan.settled()) {
        const std::vector<const PlannedPhoto*> before = plan.before();
        frame.report.photos += std::size_t(std::ranges::count_if(before, [&](const PlannedPhoto* p) {
            return std::ranges::count(drawn, p->photo, &PlannedPhoto::photo) == 0;
        }));
        resolve_before(draw_set(before, frame), frame);
    }
    const int sums = draw_set(drawn, frame);
    draw_next_surface(frame.eye);
    if (shows && !first) draw_points(frame);
    if (shows_transparent(frame.drawn.settings)) draw_transparent(frame);
    resolve(sums, frame);
}

void Renderer::pick(const Eigen::Vector2i& pixel) {
    if (points_) picking_.look(*package_, *points_, pixel, targets_.width, targets_.height);
}

void Renderer::draw_points(Frame& frame) {
    frame.report.points =
        points_->draw(frame.drawn.view, frame.drawn.clip_from_origin, frame.drawn.settings.points);
    frame.report.draws += points_->drawn().size();
}

PointSurface Renderer::point_surface(const RenderSettings& settings) const {
    if (!shows_points(settings) || !photos_on_points(settings)) return {};
    return {points_->places(), settings.points.alone};
}

/// Blends photos into empty sums. Returns the number of the sums.
int Renderer::draw_set(Pass photos, Frame& frame) {
    const RenderSettings& settings = frame.drawn.settings;
    const std::array<float, 4> zero{};
    for (const int sums : {0, 1})
        glClearNamedFramebufferfv(targets_.sums_target(sums).id(), GL_COLOR, 0, zero.data());
    int into = 0;
    draw_passes(photos, frame, false, into);
    if (settings.transients && !takes_one(settings.blend)) {
        into = 1;
        draw_passes(photos, frame, true, into);
    }
    return into;
}

DrawnView Renderer::drawn_view(const Eye& eye) const {
    return drawn_view(eye.sampled, eye.image_sets.front(), sample_.side, coarse_);
}

DrawnView Renderer::drawn_view(const View& view, const ImageSetFrame& image_set, int side,
                               bool coarse) const {
    const RenderSettings& settings = image_set.settings;
    const Eigen::Vector2d range = depth_range_of(view, settings, *image_set.plan);
    return {view,
            settings,
            *image_set.plan,
            side,
            range,
            clip_from_origin(view, range).cast<float>(),
            weights_in_image_set(settings.weights_from.value_or(view), settings.weights,
                                 settings.image_sets.shown, scene_),
            coarse};
}

/// Of the model, and of points if they are shown.
Eigen::Vector2d Renderer::depth_range_of(const View& view, const RenderSettings& settings,
                                         const ViewPlan& plan) const {
    const double reach = model_reach(package_->scene(), view.cam_from_origin);
    std::vector<std::uint32_t> all;
    if (!plan.plan().transparent.empty()) {
        all = plan.plan().clusters;
        all.insert(all.end(), plan.plan().transparent.begin(), plan.plan().transparent.end());
    }
    const Eigen::Vector2d model =
        depth_range(scene_.clusters, all.empty() ? plan.plan().clusters : all, view, reach);
    const Eigen::Vector2d anything(1, 2);
    if (!shows_points(settings)) return model.y() > 0 ? model : anything;
    const Eigen::Vector2d cloud = points_->range(view, reach);
    if (!(model.y() > 0)) return cloud.y() > 0 ? cloud : anything;
    if (!(cloud.y() > 0)) return model;
    return {std::min(model.x(), cloud.x()), std::max(model.y(), cloud.y())};
}

/// Finds out which triangles the view shows before photos are chosen for it. Waits for the graphics card.
void Renderer::find_seen(Eye& eye, const ImageSetFrame& image_set, PixelSample sample) {
    image_set.plan->update(eye.view, plan_settings(image_set.settings), image_set.photos, sample.side,
                           eye.readback.seen());
    const bool coarse = passes_.suits_coarse(eye.view, image_set.settings, image_set.plan->plan());
    passes_.draw_surface(drawn_view(eye.view, image_set, sample.side, coarse), targets_);
    take_seen(eye, true);
    eye.readback.capture(targets_, eye.view);
    take_seen(eye, true);
}

void Renderer::draw_passes(Pass photos, Frame& frame, bool transients, int& into) {
    for (Pass rest = photos; !rest.empty(); ++frame.report.passes) {
        const Pass pass = rest.first(tiles_.pass_length(rest, frame.drawn.settings));
        rest = rest.subspan(pass.size());
        if (frame.drawn.settings.complete) tiles_.load(pass, frame.drawn, frame.now, frame.report);
        if (takes_one(frame.drawn.settings.blend)) into = 1 - into;
        frame.report.draws += passes_.draw_photos(pass, frame.drawn, targets_,
                                                  point_surface(frame.drawn.settings), transients, into);
    }
}

void Renderer::resolve(int sums, const Frame& frame) {
    PictureSamples& samples = targets_.samples[frame.eye];
    const gl::Framebuffer& target = frame.second ? samples.other_target : samples.sum_target;
    const bool veiled = veils(frame.eye) && !frame.second;
    if (frame.sample.index == 0) {
        const std::array<float, 4> zero{};
        glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, zero.data());
        for (const GLint apart : {1, 2})
            if (veiled) glClearNamedFramebufferfv(samples.veiled_target.id(), GL_COLOR, apart, zero.data());
        if (!frame.second) samples.count = 0;
    }
    if (!frame.second) ++samples.count;
    bind_target((veiled ? samples.veiled_target : target).id(), targets_.size());
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw_resolved(sums, frame, false);
}

/// The picture of the photos that are being replaced, with transparent holes.
void Renderer::resolve_before(int sums, const Frame& frame) {
    bind_target(targets_.before_target.id(), targets_.size());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    draw_resolved(sums, frame, true);
}

/// `before`: the picture that is being replaced, which the other one then mixes in and finishes.
void Renderer::draw_resolved(int sums, const Frame& frame, bool before) {
    const RenderSettings& settings = frame.drawn.settings;
    const double progress = before ? 1 : frame.drawn.plan.progress();
    // The picture that is being replaced is lit, and gets its layer, with the one that replaces it.
    glUseProgram((before ? resolve_program_ : resolve_program(settings)).id());
    if (!before && settings.light.wireframe)
        glBindTextureUnit(shader::wire_unit, targets_.surface().triangles.id());
    const bool lit = !before && settings.light.light != Light::photos;
    if (lit) {
        const bool normals = settings.light.light == Light::normals;
        glUniform1i(shader::light_on_photos_uniform, settings.light.on_photos && !normals);
        glUniform1f(shader::light_scale_uniform, normals ? 1.0f : shader::light_gray);
    }
    const bool counts = settings.show == Show::coverage;
    glUniform1i(shader::takes_one_uniform, takes_one(settings.blend) && !counts);
    glUniform1i(shader::fill_uniform, !before && settings.fill_holes);
    glUniform1f(shader::progress_uniform, float(progress));
    glUniform2i(shader::frame_size_uniform, targets_.width, targets_.height);
    if (scene_.has_background()) {
        const bool dims = !before && settings.background == ShowBackground::dimmed;
        glUniform1f(shader::background_light_uniform, dims ? dimmed_light : 1.0f);
        const float hole = before                  ? 0.0f
                           : fills_holes(settings) ? HoleFilling::hole_weight(targets_.width, targets_.height)
                                                   : 1.0f;
        const auto among = float(nearness_to_photos(scene_, frame.drawn.view.cam_from_origin.center()));
        glUniform1f(shader::hole_weight_uniform, hole);
        glUniform1f(shader::plain_background_weight_uniform, among * hole + (1 - among));
    }
    if (points_) set_points(frame.drawn, before);
    if (transparent_) {
        const bool shows = !before && shows_transparent(settings);
        const bool veiled = veils(frame.eye) && !frame.second && fills_holes(settings);
        glUniform1i(shader::shows_transparent_uniform, shows);
        glUniform1i(shader::veils_holes_uniform, shows && veiled);
        if (shows) transparent_->bind();
    }
    if (!before && passes_.shows_layer(settings))
        glUniform1f(shader::layer_share_uniform, float(settings.layer.share));
    glUniform3fv(shader::plain_background_uniform, 1, settings.plain_background.top.data());
    glUniform3fv(shader::plain_background_bottom_uniform, 1, settings.plain_background.bottom.data());
    glUniform1i(shader::fill_background_uniform, settings.fill_background);
    glUniform1f(shader::max_uniform, counts ? float(std::max<std::size_t>(1, frame.report.photos)) : 0.0f);
    expose(frame.drawn);
    glBindTextureUnit(shader::sums_unit, targets_.sums[sums].id());
    glBindTextureUnit(shader::surface_unit, targets_.surface().shaded.id());
    glBindTextureUnit(shader::before_unit, progress < 1 ? targets_.before.id() : 0);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// In colors only: between counts or false colors, others would say what is not so.
bool Renderer::shows_transparent(const RenderSettings& settings) const {
    const bool hidden = shows_points(settings) && settings.points.alone;
    return transparent_ && transparent_->mode() != Transparency::off && !hidden &&
           settings.show == Show::colors && !plan().transparent.empty();
}

void Renderer::draw_transparent(Frame& frame) {
    transparent_->collect(targets_.size(), [&] {
        frame.report.draws += passes_.draw_transparent(
            frame.drawn,
            {transparent_->mode() == Transparency::exact, transparent_->row(), transparent_->capacity()});
    });
}

/// Pictures wait for the counts of their samples; a window shows what has arrived.
void Renderer::count_fragments(const Frame& frame) {
    if (!transparent_) return;
    const RenderSettings& settings = frame.drawn.settings;
    const bool wait = settings.complete || settings.wait_for_tiles;
    if (wait && frame.sample.index == 0) fragments_ = {};
    if (!shows_transparent(settings)) return;
    if (!wait && transparent_->update(false)) fragments_ = transparent_->count();
    transparent_->capture();
    if (wait && transparent_->update(true)) {
        fragments_.fragments += transparent_->count().fragments;
        fragments_.approximated += transparent_->count().approximated;
    }
}

bool Renderer::shows_points(const RenderSettings& settings) const {
    return points_ && settings.points.show && (settings.show == Show::colors || photos_on_points(settings));
}

void Renderer::set_points(const DrawnView& drawn, bool before) const {
    const bool shows = shows_points(drawn.settings) && !before;
    glUniform1i(shader::shows_points_uniform, shows);
    glUniform1i(shader::points_alone_uniform, drawn.settings.points.alone);
    glUniform1i(shader::photos_on_points_uniform, photos_on_points(drawn.settings));
    if (!shows) return;
    const Eigen::Vector2d terms = terms_of(drawn.view, drawn.depth_range);
    const double apart = std::max(1.0, drawn.view.intrinsics.height / 720.0);
    glUniform4f(shader::eye_dome_uniform, float(terms.x()), float(terms.y()),
                float(drawn.settings.points.eye_dome), float(apart));
    glBindTextureUnit(shader::points_unit, points_->picture());
    glBindTextureUnit(shader::depth_unit, targets_.surface().depth.id());
}

/// Only colors: between counts or false colors, others would say what is not so.
bool Renderer::fills_holes(const RenderSettings& settings) const {
    const bool hides_them = shows_points(settings) && settings.points.alone;
    return passes_.shows_background(settings) && settings.show == Show::colors && !hides_them;
}

/// Points alone need no photos, and neither does light, unless there are background to show.
bool Renderer::shows_photos(const RenderSettings& settings) const {
    if (shows_points(settings) && settings.points.alone) return photos_on_points(settings);
    const LightSettings& l = settings.light;
    return l.light == Light::photos || (l.on_photos && l.light != Light::normals) ||
           passes_.shows_background(settings);
}

/// Colors are summed in the mean photo's exposure and shown in the view's.
void Renderer::expose(const DrawnView& drawn) const {
    const RenderSettings& settings = drawn.settings;
    Exposure e;
    if (settings.refined_colors && settings.show == Show::colors) {
        e = drawn.view.exposure;
        if (settings.exposure && *settings.exposure < scene_.photos.size()) {
            const Exposure chosen = exposure_of(scene_.photos[*settings.exposure]);
            e.gain = chosen.gain;
            e.image_set = chosen.image_set;
        }
        // Gains are relative to photos of the same image set.
        if (e.image_set != settings.image_sets.shown) e = {};
    }
    const Intrinsics& k = drawn.view.intrinsics;
    glUniform3fv(shader::exposure_uniform, 1, e.gain.data());
    glUniform3fv(shader::vignetting_uniform, 1, e.vignetting.data());
    glUniform3f(shader::lens_uniform, float(k.cx), float(k.cy), float(2 / std::hypot(k.width, k.height)));
}

std::vector<std::uint32_t> Renderer::triangles() const {
    std::vector<std::uint32_t> out(std::size_t(targets_.width) * std::size_t(targets_.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureSubImage(targets_.surface().triangles.id(), 0, 0, 0, 0, targets_.width, targets_.height, 1,
                         GL_RED_INTEGER, GL_UNSIGNED_INT, GLsizei(out.size() * 4), out.data());
    return out;
}

void Renderer::show(const View& view, const RenderSettings& given, GLuint target, bool flip,
                    std::size_t eye) {
    const RenderSettings settings = usable(given);
    const PictureSamples& samples = targets_.samples[eye];
    const double count = std::max(samples.count, 1.0);
    const ShownImageSets& image_sets = eyes_[eye].plans.shown();
    const bool fills = fills_holes(settings_of_image_set(settings, image_sets.first, scene_));
    const bool other_fills =
        image_sets.second && fills_holes(settings_of_image_set(settings, *image_sets.second, scene_));
    if (fills || other_fills) {
        const gl::Texture& clean = veils(eye) ? samples.clean : samples.sum;
        filling_->fill(fills ? clean : samples.other, targets_.width, targets_.height, count);
    }
    begin_full_frame(show_program_, target, frame_size(view));
    glUniform2i(shader::frame_size_uniform, targets_.width, targets_.height);
    glUniform1f(shader::samples_uniform, float(count));
    glUniform1i(shader::flip_uniform, flip);
    glUniform1f(shader::soft_edges_uniform, float(settings.plain_background.soft_edges));
    glUniform3fv(shader::show_plain_background_uniform, 1, settings.plain_background.top.data());
    glUniform3fv(shader::show_plain_background_bottom_uniform, 1, settings.plain_background.bottom.data());
    glUniform1i(shader::edges_opaque_uniform, settings.fill_holes && settings.fill_background);
    if (scene_.has_background()) {
        glUniform1i(shader::fills_uniform, fills);
        glBindTextureUnit(shader::filled_unit, filling_->filled().id());
        if (transparent_) {
            glUniform1i(shader::veils_uniform, fills && veils(eye));
            glBindTextureUnit(shader::veil_unit, samples.veil.id());
        }
    }
    if (scene_.image_sets.size() > 1) show_image_sets(eye, other_fills);
    const std::uint32_t photo = settings.compare_photo;
    const bool compares = settings.compare != Compare::nothing && photo < scene_.photos.size();
    glUniform1ui(shader::compare_uniform, GLuint(compares ? settings.compare : Compare::nothing));
    if (compares) {
        const Eigen::Matrix3f photo_from_frame =
            pixels_from_pixels(scene_.intrinsics[photo], scene_.poses[photo].R, view).cast<float>();
        glUniform1f(shader::swipe_uniform, float(settings.swipe));
        glUniformMatrix3fv(shader::photo_from_frame_uniform, 1, GL_FALSE, photo_from_frame.data());
        glUniform1f(shader::lod_uniform, float(std::log2(scene_.intrinsics[photo].fx / view.intrinsics.fx)));
    }
    glBindTextureUnit(shader::accumulated_unit, samples.sum.id());
    glBindVertexArray(no_vertices_.id());
    passes_.with_photo(photo, [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
    gl::check("showing a view");
}

void Renderer::show_image_sets(std::size_t eye, bool other_fills) const {
    const ShownImageSets& image_sets = eyes_[eye].plans.shown();
    const GLuint how = !image_sets.second                             ? shader::image_sets_one
                       : image_sets.how == ImageSetView::side_by_side ? shader::image_sets_side_by_side
                       : image_sets.how == ImageSetView::swipe        ? shader::image_sets_swipe
                                                                      : shader::image_sets_mixed;
    glUniform1ui(shader::image_sets_uniform, how);
    glUniform1f(shader::image_set_share_uniform, float(image_sets.share));
    if (scene_.has_background()) glUniform1i(shader::other_fills_uniform, other_fills);
    glBindTextureUnit(shader::other_unit, image_sets.second ? targets_.samples[eye].other.id() : 0);
}

}  // namespace vantage
