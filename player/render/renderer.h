#pragma once
#include <span>
#include <vector>

#include "gl/program.h"
#include "player/plan/plan.h"
#include "player/render/frame_targets.h"
#include "player/render/model_passes.h"
#include "player/render/render_settings.h"
#include "player/render/seen_triangles.h"
#include "player/render/view_plan.h"
#include "player/stream/photo_store.h"
#include "player/view.h"

namespace vantage {

/// Which of a pixel's side * side samples a frame takes.
struct PixelSample {
    int index = 0, side = 1;
};

/// Renders a package: plans, streams, draws passes. Belongs to the OpenGL thread; the package must outlive
/// it.
class Renderer {
  public:
    Renderer(const PackageReader& package, const MemoryBudget& budget);

    /// Draws one sample of each pixel of `view` from `photos` (indices; held-out ones are left out), and adds
    /// it to the samples since the last one of index 0. `now` in seconds, for what fades; `next` is where the
    /// view is about to be, to fetch ahead. Throws Error(usage) for a view that cannot be drawn.
    FrameReport draw(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     PixelSample sample, double now, const View* next = nullptr);
    /// Shows what was drawn in the framebuffer `target`, whose whole size is the view's. `flip` where the
    /// target's first row is the lowest, as a window's is.
    void show(const View& view, const RenderSettings& settings, GLuint target, bool flip);

    /// Draws once more, as draw() last did, and returns the bytes of the distinct texels of colour, masks and
    /// depth that the picture is made of.
    std::uint64_t touched_bytes(const View& view, const RenderSettings& settings,
                                std::span<const std::uint32_t> photos, double now);

    /// The triangle at each pixel of the last draw(), from 1, first row on top; 0 where there is none. Waits.
    std::vector<std::uint32_t> triangles() const;

    /// As the last draw() left them.
    const FrameTargets& targets() const { return targets_; }

    const PackageReader& package() const { return *package_; }
    const PlanScene& scene() const { return scene_; }
    const Plan& plan() const { return plan_.plan(); }
    bool per_fragment(const RenderSettings& settings) const { return passes_.per_fragment(settings); }
    const PhotoStore& store() const { return store_; }
    /// Bytes of graphics memory that are kept to now.
    std::uint64_t graphics_budget() const { return graphics_budget_; }
    /// Panels show this photo's thumbnail: it is fetched with the next frame.
    void want_thumbnail(std::uint32_t photo) { wanted_thumbnails_.push_back(photo); }

  private:
    using Pass = std::span<const PlannedPhoto* const>;
    struct Frame {
        DrawnView drawn;
        PixelSample sample;
        double now;
        FrameReport report;
    };

    void fit(int width, int height, const RenderSettings& settings);
    void look_first(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                    PixelSample sample);
    DrawnView drawn_view(const View& view, const RenderSettings& settings, int side) const;
    std::vector<bool> ready_photos(const RenderSettings& settings) const;
    void stream(Frame& frame, const View* next);
    TileNeeds comparison_needs(const View& view, const RenderSettings& settings) const;
    void load(Pass pass, Frame& frame);
    std::size_t pass_length(Pass rest, const RenderSettings& settings) const;
    void draw_passes(Pass photos, Frame& frame, bool consensus, int& into);
    void resolve(int sums, const Frame& frame);
    void expose(const DrawnView& drawn) const;

    const PackageReader* package_;
    MemoryBudget budget_;
    std::uint64_t graphics_budget_ = 0;
    PlanScene scene_;
    PhotoStore store_;
    ModelPasses passes_;
    ViewPlan plan_;
    FrameTargets targets_;
    SeenTriangles seen_;
    gl::Program resolve_program_, show_program_;
    gl::VertexArray no_vertices_;
    double samples_ = 0;  ///< added up in targets_.accumulated
    std::vector<std::uint32_t> wanted_thumbnails_;
};

}  // namespace vantage
