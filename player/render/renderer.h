#pragma once
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/gl/program.h"
#include "player/plan/plan.h"
#include "player/render/coarsening.h"
#include "player/render/frame_tiles.h"
#include "player/render/image_set_plans.h"
#include "player/render/passes/frame_targets.h"
#include "player/render/passes/hole_filling.h"
#include "player/render/passes/model_passes.h"
#include "player/render/passes/point_pass.h"
#include "player/render/passes/point_picking.h"
#include "player/render/passes/transparent_pass.h"
#include "player/render/passes/triangle_readback.h"
#include "player/render/render_settings.h"
#include "player/stream/photo_store.h"
#include "player/view/view.h"

namespace vantage {

/// The one of a pixel's side * side samples that a frame draws.
struct PixelSample {
    int index = 0, side = 1;
};

/// Renders a package: plans, streams, draws passes. Belongs to the OpenGL thread; the package must outlive
/// it.
class Renderer {
  public:
    Renderer(const PackageReader& package, const MemoryBudget& budget);

    /// Draws one sample of each pixel of `view` from `photos` (indices; held-out photos are skipped, and
    /// those of image sets that are not shown), and adds it to the samples drawn since sample 0. `now` in
    /// seconds, for fading; `next` is the view expected soon, to prefetch for. Throws Error(usage) for a view
    /// that cannot be drawn.
    FrameReport draw(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     PixelSample sample, double now, const View* next = nullptr);
    /// The same in steps, for the views of one eye or two, of the same size. Plans for all of them, and
    /// streams what they need; paint() then draws one, and may draw the surface of the next. Unless
    /// settings.complete, photos and tiles are chosen once, for what both eyes see: these would see different
    /// colors otherwise, and it takes most of a plan.
    FrameReport prepare(std::span<const View> eyes, const RenderSettings& settings,
                        std::span<const std::uint32_t> photos, PixelSample sample, double now,
                        const View* next = nullptr);
    /// Draws an eye of the frame that was prepared last. Adds to its report.
    void paint(std::size_t eye, FrameReport& report);
    /// Replaces what the last draw() drew by its photos, as far as they had faded in, seen from another view
    /// of the same size, one sample per pixel. The plan and the fading stay those of the last draw(). With
    /// settings.weights_from of that draw's view, a surface gets the weights that it had there.
    void redraw(const View& view, const RenderSettings& settings);
    /// Shows the samples drawn for an eye in the framebuffer `target`, which has the view's size. `flip` if
    /// the target's first row is at the bottom, as a window's is.
    void show(const View& view, const RenderSettings& settings, GLuint target, bool flip,
              std::size_t eye = 0);

    /// See ModelPasses::use_records.
    void use_records(std::span<const package::PhotoRecord> photos) { passes_.use_records(photos); }
    /// See PhotoStore::use_weights. Between draws of pictures that wait for their tiles.
    void use_weights(std::function<const TransientMap*(std::uint32_t photo)> weights) {
        store_.use_weights(std::move(weights));
    }
    /// See ModelPasses::trace_texels.
    void trace_texels(GLuint buffer) { passes_.trace_texels(buffer); }

    /// The triangle at each pixel of the last draw(), row by row from the top, numbered from 1; 0: none.
    /// Waits for the graphics card.
    std::vector<std::uint32_t> triangles() const;

    /// The targets of the last draw(); their surface() is that of the eye painted last.
    const FrameTargets& targets() const { return targets_; }
    /// Of the last draw(), the terms a and b of its depth, a + b / z. Not of an orthographic view.
    Eigen::Vector2d depth_terms() const { return depth_terms_; }

    const PackageReader& package() const { return *package_; }
    /// Why a server did not give all that was requested recently; empty if it did, and for a file.
    std::string failure() const;
    const PlanScene& scene() const { return scene_; }
    std::span<const ScalarField> layers() const { return passes_.layers(); }
    /// Asks for the point at a pixel of the frame drawn last, if it was drawn with settings.points.pick or
    /// with photos on points; the answer comes a few calls later. See PointPicking.
    void pick(const Eigen::Vector2i& pixel);
    const std::optional<PickedPoint>& picked() const { return picking_.found(); }
    /// Whether points have the photos' colors where photos show them.
    bool photos_on_points(const RenderSettings& settings) const;
    /// Null if the package has no point cloud.
    const PointPass* points() const { return points_ ? &*points_ : nullptr; }
    /// The triangles that the first eye saw last, as far as they have been read back.
    SeenTriangles seen() const { return eyes_[0].readback.seen(); }
    /// Of the first eye, and the first image set that is shown.
    const Plan& plan() const { return eyes_[0].plans.plan_of_first(); }
    /// Whether the plan of an image set that is shown has this photo.
    bool uses(std::uint32_t photo) const { return eyes_[0].plans.uses(photo); }
    bool per_fragment(const RenderSettings& settings) const { return passes_.per_fragment(settings); }
    const PhotoStore& store() const { return store_; }
    /// Current limit of graphics memory, bytes: the budget's, or more if a frame needs more.
    std::uint64_t graphics_budget() const { return graphics_budget_; }
    /// Applies from the next draw().
    void set_budget(const MemoryBudget& budget);
    /// Makes the coarse mesh for swift frames on another thread, and uses it from when it is made; `wait`:
    /// now. draw() calls it when there is time.
    void coarsen(bool wait);
    /// Graphics memory that this renderer holds, bytes.
    std::uint64_t held() const { return held_; }
    /// Requests this photo's thumbnail with the next frame, for panels.
    void want_thumbnail(std::uint32_t photo) { tiles_.want_thumbnail(photo); }

  private:
    using Pass = FrameTiles::Pass;
    /// What is planned for an eye, and the triangles that it saw last.
    struct Eye {
        explicit Eye(const PlanScene& scene) : plans(scene) {}
        View view{};
        View sampled{};  ///< its pixel centers are the samples' positions
        ImageSetPlans plans;
        std::vector<ImageSetFrame> image_sets{};  ///< of the frame that was prepared last
        TriangleReadback readback{};
        std::optional<DrawnView> prepared{};  ///< if it has a surface of its own: the frame to paint
        bool has_surface = false;             ///< drawn already for that frame
    };
    struct Frame {
        DrawnView drawn;
        PixelSample sample;
        double now;
        FrameReport report;
        std::size_t eye = 0;
        bool second = false;  ///< of two image sets: its samples are accumulated by themselves
    };

    RenderSettings usable(RenderSettings settings) const;
    void fit(FrameSize frame, std::span<const ImageSetFrame> image_sets);
    void find_seen(Eye& eye, const ImageSetFrame& image_set, PixelSample sample);
    bool take_seen(Eye& eye, bool wait);
    void plan_eye(Eye& eye, PixelSample sample);
    SeenTriangles seen_by_both(const Eye& eye);
    void stream_points(const Eye& eye, FrameReport& report);
    EyeSurfaces eye_surfaces() const;
    bool may_have_own_surfaces(const RenderSettings& settings) const;
    void prepare_surfaces();
    void draw_surface(std::size_t eye, const DrawnView& drawn);
    void draw_next_surface(std::size_t eye);
    void draw_image_set(Frame& frame);
    DrawnView drawn_view(const Eye& eye) const;
    DrawnView drawn_view(const View& view, const ImageSetFrame& image_set, int side, bool coarse) const;
    void draw_present(Frame& frame);
    void draw_points(Frame& frame);
    PointSurface point_surface(const RenderSettings& settings) const;
    int draw_set(Pass photos, Frame& frame);
    void draw_passes(Pass photos, Frame& frame, bool transients, int& into);
    void resolve(int sums, const Frame& frame);
    void resolve_before(int sums, const Frame& frame);
    void draw_resolved(int sums, const Frame& frame, bool before);
    gl::Program make_resolve_program(const std::vector<std::string>& asked) const;
    const gl::Program& resolve_program(const RenderSettings& settings);
    void expose(const DrawnView& drawn) const;
    bool fills_holes(const RenderSettings& settings) const;
    bool shows_photos(const RenderSettings& settings) const;
    bool shows_points(const RenderSettings& settings) const;
    Eigen::Vector2d depth_range_of(const View& view, const RenderSettings& settings,
                                   const ViewPlan& plan) const;
    void show_image_sets(std::size_t eye, bool other_fills) const;
    void set_points(const DrawnView& drawn, bool before) const;
    bool veils(std::size_t eye) const { return bool(targets_.samples[eye].veil); }
    bool shows_transparent(const RenderSettings& settings) const;
    void draw_transparent(Frame& frame);
    void count_fragments(const Frame& frame);

    std::uint64_t held_ = gl::memory_held();  ///< until the constructor ends: what others hold
    const PackageReader* package_;
    MemoryBudget budget_;
    std::uint64_t graphics_budget_ = 0;
    PlanScene scene_;
    PhotoStore store_;
    ModelPasses passes_;
    std::deque<Eye> eyes_;  ///< one or two
    std::vector<std::uint32_t> seen_by_both_;
    std::uint64_t seen_version_ = 0;  ///< of seen_by_both_; 0: none
    FrameTiles tiles_;
    FrameTargets targets_;
    std::optional<HoleFilling> filling_;          ///< if there are background
    std::optional<PointPass> points_;             ///< if there is a cloud
    std::optional<TransparentPass> transparent_;  ///< if some of the mesh is not opaque
    FragmentCount fragments_;                     ///< of the picture
    std::optional<Coarsening> coarsening_;
    Eigen::Vector2d depth_terms_ = Eigen::Vector2d::Zero();
    PointPicking picking_;
    gl::Program resolve_program_, show_program_;
    std::map<std::vector<std::string>, gl::Program> other_resolve_programs_;  ///< by what was asked for
    gl::VertexArray no_vertices_;
    // Of the frame that was prepared last.
    PixelSample sample_;
    double now_ = 0;  ///< seconds
    EyeSurfaces surfaces_ = EyeSurfaces::in_turn;
    bool coarse_ = false;  ///< the coarse mesh is fine enough for all eyes
};

}  // namespace vantage
