#include "player/render/renderer.h"

#include "base/gl/context.h"
#include "player/render/planning/frame_memory.h"

namespace vantage {

Renderer::Renderer(const PackageReader& package, const MemoryBudget& budget)
    : resources_(package, budget),
      planner_(resources_, budget),
      resolver_(resources_),
      painter_(resources_, planner_.tiles(), resolver_) {
    held_ = gl::memory_held() - held_;
    gl::check("opening the package");
}

FrameReport Renderer::draw(const View& view, const RenderSettings& settings,
                           std::span<const std::uint32_t> photos, PixelSample sample, double now,
                           const View* next) {
    FrameReport report = prepare({{&view, 1}, settings, photos, sample, now, next});
    paint(0, report);
    return report;
}

std::vector<PixelSample> Renderer::samples(const View& view, const RenderSettings& given, int side) const {
    const RenderSettings settings = usable(given, resources_.parts);
    if (draws_samples_at_once(resources_, settings, frame_size(view), side, planner_.budget()))
        return {{.side = side, .all = true}};
    return single_samples(side);
}

FrameReport Renderer::prepare(const FrameRequest& request) {
    const std::uint64_t held_before = gl::memory_held();
    const FrameReport report = planner_.plan(request);
    painter_.begin(planner_.frame());
    held_ += gl::memory_held() - held_before;
    return report;
}

void Renderer::paint(std::size_t eye, FrameReport& report) {
    const std::uint64_t held_before = gl::memory_held();
    if (eye > 0) planner_.stream_points(planner_.frame().eyes[eye], report);
    painter_.paint(planner_.frame(), eye, report);
    planner_.finish(report);
    held_ += gl::memory_held() - held_before;
    gl::check("rendering a view");
}

void Renderer::redraw(const View& view, const RenderSettings& given) {
    check_view(view);
    const RenderSettings settings = usable(given, resources_.parts);
    if (settings.weights_from) check_view(*settings.weights_from);
    painter_.paint_again(planner_.frame(), view, settings);
    gl::check("rendering a view again");
}

void Renderer::show(const View& view, const RenderSettings& settings, const ShowTarget& target) {
    const ShownImageSets& image_sets = planner_.frame().eyes[target.eye].plans.shown();
    resolver_.show(view, usable(settings, resources_.parts), image_sets, target);
}

void Renderer::hide(std::span<const Ball> balls) {
    if (balls.empty() && resources_.scene.hidden.triangles.empty() && resources_.scene.hidden.colors.empty())
        return;
    planner_.stop_threads();
    vantage::hide(resources_.scene, balls);
    resources_.clusters.update();
}

void Renderer::pick(const Eigen::Vector2i& pixel) {
    const std::optional<PointPass>& points = resources_.points;
    const FrameTargets& targets = resources_.targets;
    if (points) picking_.look(resources_.package, *points, pixel, targets.width, targets.height);
}

}  // namespace vantage
