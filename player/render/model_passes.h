#pragma once
#include <functional>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "gl/program.h"
#include "player/plan/plan.h"
#include "player/render/frame_ring.h"
#include "player/render/frame_targets.h"
#include "player/render/model.h"
#include "player/render/render_settings.h"
#include "player/render/view_plan.h"
#include "player/stream/photo_block.h"
#include "player/stream/photo_store.h"
#include "player/view.h"

namespace vantage {

/// What is drawn in one frame, the same in all its passes.
struct DrawnView {
    const View& view;
    const RenderSettings& settings;
    const ViewPlan& plan;
    int side;  ///< samples along a pixel's side
    Eigen::Matrix4f clip_from_origin;
    std::vector<double> weights;  ///< dynamic, a photo
};

/// Draws the model: its bare surface, and over it the photos, some in each pass. Belongs to the OpenGL
/// thread; what it is made from must outlive it.
class ModelPasses {
  public:
    ModelPasses(const PackageReader& package, const PlanScene& scene, const PhotoStore& store);

    bool per_fragment(const RenderSettings& settings) const;
    /// Depth, plain shading and the triangles' numbers.
    void draw_surface(const DrawnView& drawn, const FrameTargets& targets);
    /// Adds photos to the sums `into`; best photo and consensus read the other ones. Returns how many draws
    /// that were.
    std::size_t draw_photos(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn,
                            const FrameTargets& targets, bool consensus, int into);
    /// Runs `draw` while shaders can read one photo, as it is there.
    void with_photo(std::uint32_t photo, const std::function<void()>& draw);

    /// From now on, a bit is set in this buffer for each texel that is read; 0: no more.
    void trace(GLuint buffer) { trace_ = buffer; }

  private:
    /// Draws the plan's clusters for which cluster_photos_ has bits, by one call; returns how many draws that
    /// were.
    std::size_t draw_clusters(std::span<const std::uint32_t> clusters);
    void set_uniforms(std::span<const PlannedPhoto* const> pass, const DrawnView& drawn);
    /// Writes the photos, as far as they have faded in, and their pages into the ring and binds them.
    void bind_photos(std::span<const std::uint32_t> photos, const std::vector<double>& weights,
                     const ViewPlan* plan);
    const gl::Program& blend_program(const RenderSettings& settings, bool consensus);

    const PackageReader* package_;
    const PlanScene* scene_;
    const PhotoStore* store_;
    Model model_;
    std::vector<PhotoBlock> blocks_;
    FrameRing ring_;
    gl::Program surface_program_;
    std::map<std::tuple<int, bool, Blend, bool, bool, bool, int, bool>, gl::Program> blend_programs_;
    std::vector<std::uint32_t> cluster_photos_;  ///< of a pass, a cluster: a bit a photo
    GLuint trace_ = 0;
};

}  // namespace vantage
