#pragma once
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "base/gl/program.h"
#include "player/plan/plan.h"
#include "player/render/frame_ring.h"
#include "player/render/passes/blend_program.h"
#include "player/render/passes/cluster_draws.h"
#include "player/render/passes/drawn_view.h"
#include "player/render/passes/frame_targets.h"
#include "player/render/render_trials.h"
#include "player/render/scene_parts.h"
#include "player/stream/photo_block.h"
#include "player/stream/photo_store.h"

namespace vantage {

/// A frame's points as a surface for photos.
struct PointSurface {
    GLuint places = 0;   ///< texture, see PointPass::places(); 0: no photos on points
    bool alone = false;  ///< the model is hidden
};

/// Draws photos on the model and on points, several per pass. Must be used on the OpenGL thread. The
/// objects passed to the constructor must outlive the PhotoPasses.
class PhotoPasses {
  public:
    PhotoPasses(const PackageReader& package, const PlanScene& scene, const PhotoStore& store,
                ClusterDraws& clusters, const SceneParts& parts, const RenderTrials& trials);

    /// Replaces the cameras and colors used for drawing photos, for measurements. Plans still use the
    /// package's records.
    void use_records(std::span<const package::PhotoRecord> photos);
    bool per_fragment(const RenderSettings& settings) const;
    /// Whether photos are blended once per pixel of the frame.
    bool by_triangle(const RenderSettings& settings) const;
    /// Adds photos to the sums `into`; best photo and transient masking read the other sums. Returns the
    /// number of draws.
    std::size_t draw(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                     const FrameTargets& targets, const PointSurface& points, bool transients, int into);
    /// Adds photos of the background to the sums `into` (see plan_background). Returns the number of draws: 0
    /// if the driver does not support reading the model per pixel.
    std::size_t draw_background(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                                const FrameTargets& targets, const PointSurface& points, int into);
    /// Runs `draw` with the resident parts of one photo bound as photo 0.
    void with_photo(std::uint32_t photo, const std::function<void()>& draw);

    /// Makes passes set a bit in this buffer for each texel that they read, ordered by the layers of color,
    /// weight maps and depth; 0 disables this.
    void trace_texels(GLuint buffer) { trace_ = buffer; }

  private:
    void draw_on_frame(const FrameTargets& targets, const PointSurface& points);
    void bind_frame(const FrameTargets& targets, const PointSurface& points) const;
    void draw_frame(GLenum depth_test) const;
    void set_uniforms(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn, BlendOn on);
    void draw_on_points(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                        const PointSurface& points, bool transients);
    /// Writes the photos and their pages into the ring, and binds them. `weights`: one per photo of the
    /// scene; if empty, all are 1.
    template <class Weight>
    void bind_photos(std::span<const std::uint32_t> photos, std::span<const Weight> weights);
    const gl::Program& blend_program(const RenderSettings& settings, bool transients, BlendOn on,
                                     bool behind_points);

    const PackageReader* package_;
    const PlanScene* scene_;
    const PhotoStore* store_;
    /// Its draws are in a separate ring: a software rasterizer waits before reading draws from a buffer that
    /// photos use.
    ClusterDraws* clusters_;
    const SceneParts* parts_;
    const RenderTrials* trials_;
    std::vector<PhotoBlock> blocks_;
    FrameRing ring_;  ///< photos and their pages
    gl::VertexArray no_vertices_;
    std::map<BlendVariant, gl::Program> blend_programs_;
    std::vector<std::uint32_t> cluster_photos_;  ///< per cluster: one bit per photo of the pass
    std::vector<float> shares_;                  ///< see find_nearest_shares
    GLuint trace_ = 0;
};

}  // namespace vantage
