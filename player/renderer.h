#pragma once
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "gl/program.h"
#include "player/frame_ring.h"
#include "player/frame_targets.h"
#include "player/model.h"
#include "player/photo_block.h"
#include "player/photo_store.h"
#include "player/plan.h"
#include "player/render_settings.h"
#include "player/seen_triangles.h"
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
    /// view is about to be, to fetch ahead.
    FrameReport draw(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     PixelSample sample, double now, const View* next = nullptr);
    /// Shows what was drawn in the framebuffer `target`, whose whole size is the view's. `flip` where the
    /// target's first row is the lowest, as a window's is.
    void show(const View& view, const RenderSettings& settings, GLuint target, bool flip);

    /// Draws once more, as draw() last did, and returns the bytes of the distinct texels of colour, masks and
    /// depth that the picture is made of.
    std::uint64_t touched_bytes(const View& view, const RenderSettings& settings,
                                std::span<const std::uint32_t> photos, double now);

    const PackageReader& package() const { return *package_; }
    const PlanScene& scene() const { return scene_; }
    const Plan& plan() const { return plan_; }
    bool per_fragment(const RenderSettings& settings) const;
    const PhotoStore& store() const { return store_; }
    /// Bytes of graphics memory that are kept to now.
    std::uint64_t graphics_budget() const { return graphics_budget_; }
    /// Panels show this photo's thumbnail: it is fetched with the next frame.
    void want_thumbnail(std::uint32_t photo) { wanted_thumbnails_.push_back(photo); }

  private:
    using Photos = std::vector<const PlannedPhoto*>;
    using Pass = std::span<const PlannedPhoto* const>;
    /// What is drawn in one frame, the same in all its passes.
    struct Frame {
        const View& view;
        const RenderSettings& settings;
        PixelSample sample;
        Eigen::Matrix4f clip_from_origin;
        std::vector<double> weights;  ///< dynamic, a photo
        FrameReport report;
    };

    void fit(int width, int height, const RenderSettings& settings);
    void make_plan_for(const View& view, const RenderSettings& settings,
                       std::span<const std::uint32_t> photos, int side);
    void look_first(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                    PixelSample sample);
    void update_presence(const RenderSettings& settings, double now);
    Photos present_photos(const RenderSettings& settings) const;
    void stream(Frame& frame, const View* next);
    TileNeeds comparison_needs(const View& view, const RenderSettings& settings) const;
    void load(Pass pass, Frame& frame);
    std::size_t pass_length(Pass rest, const RenderSettings& settings) const;

    void draw_surface(const Frame& frame);
    void draw_passes(Pass photos, Frame& frame, bool consensus, int& into);
    void draw_pass(Pass pass, Frame& frame, bool consensus, int into);
    void set_uniforms(Pass pass, const Frame& frame);
    /// Writes the photos and their pages into the ring and binds them.
    void bind_photos(std::span<const std::uint32_t> photos, const std::vector<double>& weights);
    /// Draws the plan's clusters for which `photos` has bits, by one call; returns how many draws that were.
    std::size_t draw_clusters(const std::vector<std::uint32_t>& photos);
    void resolve(int sums, const Frame& frame);
    const gl::Program& blend_program(const RenderSettings& settings, bool consensus);

    const PackageReader* package_;
    MemoryBudget budget_;
    std::uint64_t graphics_budget_ = 0;
    PlanScene scene_;
    Model model_;
    std::vector<PhotoBlock> blocks_;
    PhotoStore store_;
    FrameRing ring_;
    FrameTargets targets_;
    SeenTriangles seen_;
    gl::Program surface_program_, resolve_program_, show_program_;
    gl::VertexArray no_vertices_;
    std::map<std::tuple<int, bool, Blend, bool, bool>, gl::Program> blend_programs_;
    gl::Buffer touched_;  ///< while texels are traced

    /// What plan_ was made for.
    struct PlanKey {
        View view;
        PlanSettings settings;
        std::vector<std::uint32_t> photos;
        std::uint64_t seen;  ///< version
    };
    std::optional<PlanKey> planned_for_;
    bool knows_seen_ = false;  ///< the plan was made with what the view shows
    Plan plan_;
    std::vector<PlannedPhoto> leaving_;  ///< not planned any more, fading out
    std::vector<float> presence_;        ///< a photo, 0 to 1
    double last_ = 0;
    std::vector<std::uint32_t> cluster_photos_;  ///< of a pass, a cluster: a bit a photo
    double samples_ = 0;                         ///< added up in targets_.accumulated
    std::vector<std::uint32_t> wanted_thumbnails_;
};

}  // namespace vantage
