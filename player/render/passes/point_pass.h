#pragma once
#include <Eigen/Core>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "player/plan/point_plan.h"
#include "player/render/frame_ring.h"
#include "player/render/passes/frame_targets.h"
#include "player/render/render_settings.h"
#include "player/stream/point_store.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {

/// Plans, streams and draws a package's point cloud, occluded by the model. Must be used on the OpenGL
/// thread. The package must outlive it.
class PointPass {
  public:
    /// `bytes`: graphics memory for points.
    PointPass(const PackageReader& package, PointCloud cloud, std::uint64_t bytes);

    void release() { target_ = {}, picture_ = {}, places_ = {}, numbers_ = {}; }
    /// Creates the target for frames of at most the targets' allocated size, with a copy of the model's depth
    /// and, if `placed`, with places() and numbers().
    void fit(const FrameTargets& targets, bool placed);
    static std::uint64_t bytes(int width, int height, bool placed) {
        return std::uint64_t(width) * std::uint64_t(height) * (placed ? 20 : 8);
    }
    bool placed() const { return bool(places_); }

    /// Chooses nodes for the view, requests them and uploads those that have arrived. If the settings require
    /// waiting for tiles, waits for all nodes. Returns the number of bytes uploaded.
    std::size_t stream(const View& view, const RenderSettings& settings, int side, double now);
    /// The number of planned nodes that are not yet loaded.
    std::size_t missing() const { return missing_; }
    std::size_t damaged() const { return store_.damaged(); }
    std::size_t absent() const { return store_.absent(); }
    std::string failure() const { return store_.failure(); }
    std::uint64_t growth() const { return store_.growth(); }  ///< see PointStore
    const PointPlan& plan() const { return plan_; }
    const PointCloud& cloud() const { return cloud_; }
    /// See depth_range() in point_plan.h.
    Eigen::Vector2d range(const View& view, double reach) const {
        return depth_range(cloud_, plan_, view, reach);
    }
    /// Draws into picture(), over the depth of the model. Returns the number of points.
    std::size_t draw(const View& view, const Eigen::Matrix4f& clip_from_origin,
                     const PointSettings& settings);
    /// Linear light; alpha is 1 at points.
    GLuint picture() const { return picture_.id(); }
    /// For each pixel, the distance of its point along the view's axis (0 without a point), and the spacing
    /// of points there.
    GLuint places() const { return places_.id(); }
    /// For each pixel, the number of its point, for point_numbered(); 0 means none.
    GLuint numbers() const { return numbers_.id(); }
    /// The nodes drawn by the last draw().
    const std::vector<DrawnNode>& drawn() const { return drawn_; }

  private:
    PointCloud cloud_;
    std::vector<float> spacings_;  ///< per node
    bool only_;                    ///< no model can occlude the cloud
    PointStore store_;
    PointPlan plan_;
    std::size_t missing_ = 0;
    FrameRing ring_;
    std::vector<DrawnNode> drawn_;
    gl::Program program_, placed_program_;  ///< placed_program_ is made on demand
    gl::VertexArray vertices_;
    gl::Texture picture_, places_, numbers_;
    gl::Framebuffer target_;
};

}  // namespace vantage
