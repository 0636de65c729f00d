#include "player/render/frame_painter.h"

#include <algorithm>

#include "player/render/passes/blend_table.h"

namespace vantage {

void FramePainter::begin(const PlannedFrame& frame) {
    FrameResources& r = *resources_;
    const DrawnRegion region(r.targets);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        surfaces_.at(i).prepared.reset();
        surfaces_.at(i).drawn = i < frame.eyes.size() && frame.eyes[i].surface_drawn;
    }
    coarse_ = std::ranges::all_of(frame.eyes, [&](const PlannedEye& eye) {
        return suits_coarse(r, eye.sampled, eye.image_sets.front());
    });
    // Points share the depth of one surface, but two image sets may have different surfaces.
    const std::vector<ImageSetFrame>& image_sets = frame.eyes.front().image_sets;
    const RenderSettings& settings = image_sets.front().settings;
    const bool own = image_sets.size() == 1 && !shows_points(settings, r.parts);
    how_ = own ? eye_surfaces(r, settings, frame.eyes.size()) : EyeSurfaces::in_turn;
    if (how_ == EyeSurfaces::in_turn) return;
    for (std::size_t i = 0; i < frame.eyes.size(); ++i) {
        const PlannedEye& eye = frame.eyes[i];
        surfaces_.at(i).prepared.emplace(
            drawn_view(r, eye.sampled, eye.image_sets.front(), frame.sample.side, coarse_));
    }
    if (how_ != EyeSurfaces::at_once) return;
    r.pass_clock.begin(TimedPass::surface);
    r.surface.draw_both(*surfaces_[0].prepared, *surfaces_[1].prepared, r.targets);
    for (OwnSurface& surface : surfaces_) surface.drawn = true;
}

void FramePainter::paint(PlannedFrame& frame, std::size_t number, FrameReport& report) {
    FrameResources& r = *resources_;
    PlannedEye& eye = frame.eyes[number];
    const DrawnRegion region(r.targets);
    OwnSurface& own = surfaces_.at(number);
    const auto image_set_of = [&](const ImageSetFrame& b) {
        const bool takes = !b.second && own.prepared;
        return PaintedImageSet{.drawn = takes ? std::move(*own.prepared)
                                              : drawn_view(r, eye.sampled, b, frame.sample.side, coarse_),
                               .sample = frame.sample,
                               .now = frame.now,
                               .eye = number,
                               .second = b.second,
                               .transparent = shows_transparent(r, b.settings, frame.first_plan())};
    };
    PaintedImageSet first = image_set_of(eye.image_sets.front());
    own.prepared.reset();
    first.report = report;
    r.targets.depth_terms = depth_terms(first.drawn.view, first.drawn.depth_range);
    draw_surface(number, first.drawn);
    own.drawn = false;  // after painting, it may be overwritten
    if (!is_complete(first.drawn.settings.loading)) eye.readback.capture(r.targets, eye.view);
    draw_photos(first);
    report = first.report;
    for (const ImageSetFrame& b : std::span(eye.image_sets).subspan(1)) {
        PaintedImageSet second = image_set_of(b);
        // Draws the second image set's own surface, which may lack the background.
        r.pass_clock.begin(TimedPass::surface);
        r.surface.draw(second.drawn, r.targets);
        draw_photos(second);
        report = joined(report, second.report);
    }
    r.pass_clock.end();
    count_fragments(first, report);
}

void FramePainter::paint_again(PlannedFrame& frame, const View& view, const RenderSettings& settings) {
    FrameResources& r = *resources_;
    r.targets.surface_number = 0;
    std::vector<ImageSetFrame> image_sets;
    frame.eyes.front().plans.find_frames(settings, {}, image_sets);
    for (const ImageSetFrame& b : image_sets) {
        PaintedImageSet image_set{.drawn = drawn_view(r, view, b, 1, coarse_),
                                  .second = b.second,
                                  .transparent = shows_transparent(r, b.settings, frame.first_plan())};
        r.surface.draw(image_set.drawn, r.targets);
        draw_photos(image_set);
    }
}

/// Draws the bare surface of an eye, unless it has been drawn.
void FramePainter::draw_surface(std::size_t eye, const DrawnView& drawn) {
    FrameTargets& targets = resources_->targets;
    targets.surface_number = how_ == EyeSurfaces::in_turn ? 0 : eye;
    OwnSurface& surface = surfaces_.at(eye);
    resources_->pass_clock.begin(TimedPass::surface);
    if (!surface.drawn) resources_->surface.draw(drawn, targets);
    surface.drawn = true;
}

/// A software rasterizer prepares triangles on one thread, while others can blend an eye's photos.
void FramePainter::draw_next_surface(std::size_t eye) {
    const std::size_t next = eye + 1;
    if (next >= surfaces_.size() || !surfaces_[next].prepared) return;
    draw_surface(next, *surfaces_[next].prepared);
    resources_->targets.surface_number = eye;
}

/// Draws the photos on the surface; during a transition, also those that are being replaced.
void FramePainter::draw_photos(PaintedImageSet& image_set) {
    const ViewPlan& plan = image_set.drawn.plan;
    const Pass drawn = plan.drawn();
    image_set.report.photos = drawn.size();
    // Points that receive photos are drawn first: their depth keeps photos off the model behind them.
    const SceneParts& parts = resources_->parts;
    const bool shows = shows_points(image_set.drawn.settings, parts),
               first = photos_on_points(image_set.drawn.settings, parts);
    if (shows && first) draw_points(image_set);
    if (!plan.settled()) {
        const Pass before = plan.before();
        image_set.report.photos += std::size_t(std::ranges::count_if(before, [&](const PlannedPhoto* p) {
            return std::ranges::count(drawn, p->photo, &PlannedPhoto::photo) == 0;
        }));
        resolver_->resolve_before(draw_set(before, image_set), image_set);
    }
    const int sums = draw_set(drawn, image_set);
    draw_background(image_set, sums);
    draw_next_surface(image_set.eye);
    if (shows && !first) draw_points(image_set);
    if (image_set.transparent) draw_transparent(image_set);
    resolver_->resolve(sums, image_set);
}

void FramePainter::draw_points(PaintedImageSet& image_set) {
    PointPass& points = *resources_->points;
    resources_->pass_clock.begin(TimedPass::points);
    image_set.report.points =
        points.draw(image_set.drawn.view, image_set.drawn.clip_from_origin, image_set.drawn.settings.points);
    image_set.report.draws += points.drawn().size();
}

/// Blends photos into empty sums and returns the index of these sums.
int FramePainter::draw_set(Pass photos, PaintedImageSet& image_set) {
    const RenderSettings& settings = image_set.drawn.settings;
    resources_->pass_clock.begin(TimedPass::photos);
    const std::array<float, 4> zero{};
    for (const int sums : {0, 1})
        if (resources_->targets.sums[sums])
            glClearNamedFramebufferfv(resources_->targets.sums_target(sums).id(), GL_COLOR, 0, zero.data());
    int into = 0;
    draw_passes(photos, image_set, false, into);
    if (settings.transients && !takes_one(settings.blend)) {
        into = 1;
        draw_passes(photos, image_set, true, into);
    }
    return into;
}

void FramePainter::draw_passes(Pass photos, PaintedImageSet& image_set, bool transients, int& into) {
    FrameResources& r = *resources_;
    const RenderSettings& settings = image_set.drawn.settings;
    const PointSurface on_points = point_surface(settings);
    for (Pass rest = photos; !rest.empty(); ++image_set.report.passes) {
        const Pass pass = rest.first(tiles_->pass_length(rest, settings, settings.photos_per_pass));
        rest = rest.subspan(pass.size());
        if (is_complete(settings.loading))
            tiles_->load(pass, image_set.drawn, image_set.now, image_set.report);
        if (takes_one(settings.blend)) into = 1 - into;
        image_set.report.draws +=
            r.photos.draw(pass, image_set.drawn, r.targets, on_points, transients, into);
    }
}

/// Adds the background's photos to the sums with index `into`.
void FramePainter::draw_background(PaintedImageSet& image_set, int into) {
    FrameResources& r = *resources_;
    const RenderSettings& settings = image_set.drawn.settings;
    const PointSurface points = point_surface(settings);
    if (points.alone || !shows_background(settings, r.parts)) return;
    r.pass_clock.begin(TimedPass::background);
    for (Pass rest = tiles_->ready_behind(settings, image_set.drawn.plan.plan()); !rest.empty();
         ++image_set.report.passes) {
        const Pass pass = rest.first(tiles_->pass_length(rest, settings, max_photos_per_pass));
        rest = rest.subspan(pass.size());
        if (is_complete(settings.loading))
            tiles_->load(pass, image_set.drawn, image_set.now, image_set.report);
        image_set.report.draws += r.photos.draw_background(pass, image_set.drawn, r.targets, points, into);
    }
}

/// The points that receive photos.
PointSurface FramePainter::point_surface(const RenderSettings& settings) const {
    const SceneParts& parts = resources_->parts;
    if (!shows_points(settings, parts) || !photos_on_points(settings, parts)) return {};
    return {resources_->points->places(), settings.points.alone};
}

void FramePainter::draw_transparent(PaintedImageSet& image_set) {
    TransparentPass& pass = *resources_->transparent;
    resources_->pass_clock.begin(TimedPass::transparent);
    pass.collect(resources_->targets.size(), [&] {
        image_set.report.draws += resources_->surface.draw_transparent(
            image_set.drawn, {pass.mode() == Transparency::exact, pass.row(), pass.capacity()});
    });
}

/// Pictures wait for their own fragment counts; a window shows the latest counts available.
void FramePainter::count_fragments(const PaintedImageSet& image_set, FrameReport& report) {
    if (!resources_->transparent) return;
    TransparentPass& pass = *resources_->transparent;
    const bool wait = waits_for_tiles(image_set.drawn.settings.loading);
    if (wait && image_set.sample.index == 0) fragments_ = {};
    if (image_set.transparent) {
        if (!wait && pass.update(false)) fragments_ = pass.count();
        pass.capture();
        if (wait && pass.update(true)) {
            fragments_.fragments += pass.count().fragments;
            fragments_.approximated += pass.count().approximated;
        }
    }
    report.fragments = fragments_.fragments, report.fragments_approximated = fragments_.approximated;
}

}  // namespace vantage
