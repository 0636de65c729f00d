#include "player/render/planning/frame_planner.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/text/error.h"
#include "player/render/passes/blend_table.h"
#include "player/render/planning/frame_memory.h"
#include "player/render/timing/pace.h"

namespace vantage {
namespace {

/// The view shifted so that its pixel centers are the positions of one sample, or the view enlarged to one
/// pixel per sample.
View sampled(View view, PixelSample s) {
    if (s.all) return scaled(view, s.side);
    view.intrinsics.cx -= (s.index % s.side + 0.5) / s.side - 0.5;
    view.intrinsics.cy -= (s.index / s.side + 0.5) / s.side - 0.5;
    return view;
}

/// Points and background require perspective. Throws Error(usage).
void expect_perspective(const View& view, bool points, bool background) {
    if (view.orthographic_depth > 0 && (points || background))
        throw Error(Exit::usage, "an orthographic view shows neither points nor background");
}

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

FramePlanner::FramePlanner(FrameResources& resources, const MemoryBudget& budget)
    : resources_(&resources), budget_(budget), tiles_(resources), maker_(resources.scene) {
    frame_.eyes.emplace_back(resources.scene);
}

void FramePlanner::set_budget(const MemoryBudget& budget) {
    if (budget.graphics != budget_.graphics) resources_->targets = {};  // must be divided again
    budget_ = budget;
}

void FramePlanner::coarsen(bool wait) {
    if (coarse_triangles(resources_->scene) == 0) return;
    if (!coarsening_) coarsening_.emplace(resources_->scene);
    if (auto mesh = coarsening_->take(wait)) resources_->clusters.use_coarse(std::move(*mesh));
}

void FramePlanner::stop_threads() {
    coarsening_.reset();
    maker_.stop_thread();
}

FrameReport FramePlanner::plan(const FrameRequest& request) {
    FrameResources& r = *resources_;
    for (const View& view : request.eyes) check_view(view);
    const RenderSettings settings = usable(request.settings, r.parts);
    const bool complete = is_complete(settings.loading);
    expect_perspective(request.eyes.front(), shows_points(settings, r.parts),
                       shows_background(settings, r.parts));
    if (settings.weights_from) check_view(*settings.weights_from);
    choose_image_sets(request, settings);
    if (r.fields.load(settings, r.clusters)) r.targets = {};  // the budget must be divided again
    fit();
    const DrawnRegion region(r.targets);
    // A frame that waits for data shows the data at full weight.
    const bool fades = settings.loading == Loading::streamed || settings.loading == Loading::beginning;
    r.store.begin_frame(frame_.now, fades);
    FrameReport report;
    if (!complete)
        for (PlannedEye& eye : frame_.eyes) take_seen(eye, waits_for_tiles(settings.loading));
    const auto planning = std::chrono::steady_clock::now();
    ordered_.clear();
    for (PlannedEye& eye : frame_.eyes) order_plans(eye);
    // While frames are reduced, nothing is planned ahead: frames at rest are slow, and drawing one takes
    // longer than planning it.
    maker_.update(ordered_, settings.loading != Loading::streamed, settings.reduced ? nullptr : request.next);
    report.plan_ms = milliseconds_since(planning);
    if (complete) make_room();
    stream_points(frame_.eyes.front(), report);
    report.clusters = frame_.first_plan().in_view().opaque.size();
    report.uncovered = frame_.plan().uncovered;
    if (!complete) tiles_.stream(frame_, maker_.ahead(), report);
    for (const PlannedEye& eye : frame_.eyes)
        for (const ImageSetFrame& image_set : eye.image_sets)
            image_set.plan->fade(plan_settings(image_set.settings, r.trials.anisotropy), frame_.now,
                                 tiles_.ready_photos(image_set.settings, image_set.plan->plan()));
    return report;
}

void FramePlanner::choose_image_sets(const FrameRequest& request, const RenderSettings& settings) {
    std::span<const std::uint32_t> photos = request.photos;
    if (!shows_photos(settings, resources_->parts)) photos = {};
    frame_.sample = request.sample, frame_.now = request.now;
    std::deque<PlannedEye>& eyes = frame_.eyes;
    if (eyes.size() != request.eyes.size()) seen_by_both_ = {};
    while (eyes.size() > request.eyes.size()) eyes.pop_back();
    while (eyes.size() < request.eyes.size()) eyes.emplace_back(resources_->scene);
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        PlannedEye& eye = eyes[i];
        eye.view = request.eyes[i];
        eye.sampled = sampled(eye.view, request.sample);
        eye.surface_drawn = false;
        if (i == 0)
            eye.plans.choose(settings, request.now);
        else
            eye.plans.follow(eyes.front().plans);  // keeps the eyes' fades in step
        eye.plans.find_frames(settings, photos, eye.image_sets);
    }
}

/// Allocates targets for the frame, unless they exist.
void FramePlanner::fit() {
    FrameResources& r = *resources_;
    const std::vector<ImageSetFrame>& image_sets = frame_.eyes.front().image_sets;
    const FrameSize size = frame_size(frame_.eyes.front().view);
    const FrameNeeds needs = needs_of(r, size, image_sets, frame_.eyes.size(), frame_.sample.drawn());
    if (!has(r, needs)) {
        r.targets = {};
        for (PlannedEye& eye : frame_.eyes) eye.readback.release();
        if (r.points) r.points->release();
        if (r.transparent) r.transparent->release();
        graphics_budget_ = make_targets(r, needs, budget_);
    }
    r.targets.width = size.width, r.targets.height = size.height;
    r.targets.surface_number = 0;
    const RenderSettings& settings = image_sets.front().settings;
    if (takes_one(settings.blend) || settings.transients) r.targets.add_second_sums();
    for (PictureSamples& samples : r.targets.samples) {
        if (image_sets.size() > 1) samples.add_other();
        if (needs.veiled) samples.add_veil();
    }
}

bool FramePlanner::take_seen(PlannedEye& eye, bool wait) {
    return eye.readback.update(wait, resources_->scene.triangles, resources_->clusters.coarse().stands_for);
}

/// Requests plans for an eye's image sets. In a frame that is not complete, the first eye's plans serve both
/// eyes: the second eye's plans use the photos of the first eye's plans and have no tiles of their own.
void FramePlanner::order_plans(PlannedEye& eye) {
    PlannedEye& first = frame_.eyes.front();
    for (std::size_t b = 0; b < eye.image_sets.size(); ++b) {
        const ImageSetFrame& image_set = eye.image_sets[b];
        const bool complete = is_complete(image_set.settings.loading);
        PlanSettings how = plan_settings(image_set.settings, resources_->trials.anisotropy);
        // Photos on points also show parts of the scene beyond the visible triangles.
        const bool on_points = photos_on_points(image_set.settings, resources_->parts);
        // A frame that waits for tiles needs those of its own visible triangles.
        const bool waits =
            complete || (image_set.settings.loading == Loading::uploading && frame_.eyes.size() == 1);
        if (waits && !on_points && frame_.sample.index == 0) find_seen(eye, image_set);
        OrderedPlan ordered{image_set.plan};
        if (&eye != &first && !complete) {
            ordered.shares = first.image_sets.at(b).plan;
            how.tiles = false;
        }
        SeenTriangles seen = complete || frame_.eyes.size() == 1 ? eye.readback.seen() : seen_by_both();
        if (complete && on_points) seen.numbers = nullptr;
        image_set.plan->order(eye.view, how, image_set.photos, frame_.sample.side, seen);
        ordered_.push_back(ordered);
    }
}

void FramePlanner::make_room() {
    constexpr std::uint64_t most = std::uint64_t(1) << 30;
    if (budget_.graphics > 0) return;
    const PhotoStore& store = resources_->store;
    const std::uint64_t before = store.residency().layout().bytes();
    tiles_.make_room(frame_, most);
    graphics_budget_ += store.residency().layout().bytes() - before;
}

/// Determines the view's visible triangles before photos are chosen for it. Waits for the graphics card.
void FramePlanner::find_seen(PlannedEye& eye, const ImageSetFrame& image_set) {
    FrameResources& r = *resources_;
    const int side = frame_.sample.side;
    const PlanSettings surface = plan_settings(image_set.settings, r.trials.anisotropy);
    const bool complete = is_complete(image_set.settings.loading);
    image_set.plan->order(eye.view, surface, complete ? std::span<const std::uint32_t>() : image_set.photos,
                          side, eye.readback.seen());
    if (complete) image_set.plan->take(nullptr);  // pictures do not depend on previous ones
    r.surface.draw(drawn_view(r, eye.sampled, image_set, side, suits_coarse(r, eye.sampled, image_set)),
                   r.targets);
    // The range of depths depends on the points, which are not loaded yet.
    eye.surface_drawn =
        frame_.eyes.size() == 1 && eye.image_sets.size() == 1 && !shows_points(image_set.settings, r.parts);
    take_seen(eye, true);
    eye.readback.capture(r.targets, eye.view);
    take_seen(eye, true);
}

/// The triangles visible to at least one eye, combined as for a single view.
const SeenTriangles& FramePlanner::seen_by_both() {
    const SeenTriangles left = frame_.eyes[0].readback.seen(), right = frame_.eyes[1].readback.seen();
    if (const std::uint64_t version = left.version + right.version; version != seen_by_both_.version) {
        auto numbers = std::make_shared<std::vector<std::uint32_t>>();
        std::ranges::copy(left.triangles(), std::back_inserter(*numbers));
        std::ranges::copy(right.triangles(), std::back_inserter(*numbers));
        seen_by_both_ = {std::move(numbers), left.view, version, false};
    }
    return seen_by_both_;
}

void FramePlanner::stream_points(const PlannedEye& eye, FrameReport& report) {
    const RenderSettings& settings = eye.image_sets.front().settings;
    if (!shows_points(settings, resources_->parts)) return;
    PointPass& points = *resources_->points;
    report.uploaded += points.stream(eye.view, settings, frame_.sample.side, frame_.now);
    report.nodes_missing += points.missing();
}

void FramePlanner::finish(FrameReport& report) {
    const std::optional<PointPass>& points = resources_->points;
    const Residency& residency = resources_->store.residency();
    report.tiles_damaged = residency.damaged_count() + (points ? points->damaged() : 0);
    report.tiles_absent = residency.absent_count() + (points ? points->absent() : 0);
    const bool planned =
        std::ranges::all_of(frame_.eyes, [](const PlannedEye& e) { return e.plans.settled(); });
    report.settled = report.tiles_to_come == 0 && report.nodes_missing == 0 && planned && maker_.current() &&
                     residency.settled();
    const RenderSettings& settings = frame_.eyes.front().image_sets.front().settings;
    const bool has_time = settings.reduced ? settings.loading != Loading::beginning
                                           : report.settled && !is_complete(settings.loading);
    if (has_time) coarsen(false);
}

}  // namespace vantage
