#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/plan/hidden_balls.h"
#include "player/render/frame_painter.h"
#include "player/render/frame_resolver.h"
#include "player/render/frame_resources.h"
#include "player/render/passes/point_picking.h"
#include "player/render/planning/frame_planner.h"

namespace vantage {

/// Renders a package: plans, paints and shows frames. Must be used on the OpenGL thread. The package must
/// outlive it.
class Renderer {
  public:
    Renderer(const PackageReader& package, const MemoryBudget& budget);

    /// The frames that together give each pixel `side` * `side` samples for one eye: one frame for all
    /// samples, or one frame per sample.
    std::vector<PixelSample> samples(const View& view, const RenderSettings& settings, int side) const;
    /// Draws one or all samples of each pixel of `view` (see FrameRequest). Throws Error(usage) if the view
    /// cannot be drawn.
    FrameReport draw(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     PixelSample sample, double now, const View* next = nullptr);
    /// Like draw() but in steps, and for one or two eyes. prepare() plans for all eyes and streams their
    /// data; paint() then draws one eye, and may draw the surface of the next one. See FramePlanner::plan().
    FrameReport prepare(const FrameRequest& request);
    /// Draws an eye of the last prepared frame, and adds to that frame's report.
    void paint(std::size_t eye, FrameReport& report);
    /// Replaces the picture of the last draw() with another view of the same size, which shows the same
    /// photos with one sample per pixel. The plan and the state of fading do not change. If
    /// settings.weights_from is the view of the last draw(), surfaces keep their weights.
    void redraw(const View& view, const RenderSettings& settings);
    /// Shows the samples of an eye in a framebuffer of the view's size.
    void show(const View& view, const RenderSettings& settings, const ShowTarget& target);

    /// Hides the mesh and the background in balls, and shows again what an earlier call has hidden.
    void hide(std::span<const Ball> balls);

    /// Requests the point at a pixel of the last frame, if that frame was drawn with settings.points.pick or
    /// with photos on points. The answer arrives a few calls later. See PointPicking.
    void pick(const Eigen::Vector2i& pixel);
    const std::optional<PickedPoint>& picked() const { return picking_.found(); }

    const PackageReader& package() const { return resources_.package; }
    const PlanScene& scene() const { return resources_.scene; }
    FrameResources& resources() { return resources_; }
    const FrameResources& resources() const { return resources_; }
    FramePlanner& planner() { return planner_; }
    const FramePlanner& planner() const { return planner_; }
    /// Graphics memory that this renderer holds, in bytes.
    std::uint64_t held() const { return held_; }

  private:
    std::uint64_t held_ = gl::memory_held();  ///< during construction, the amount that others hold
    FrameResources resources_;
    FramePlanner planner_;
    FrameResolver resolver_;
    FramePainter painter_;
    PointPicking picking_;
};

}  // namespace vantage
