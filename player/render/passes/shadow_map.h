#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/plan_scene.h"
#include "player/plan/section_plane.h"
#include "player/render/passes/frame_targets.h"

namespace vantage {

/// A part of the mesh as it is seen from a distant light.
struct LitView {
    View view;                           ///< orthographic, toward where the light goes
    std::vector<SectionPlane> sections;  ///< that cut the mesh
    bool coarse = false;                 ///< the coarse mesh replaces the mesh
    std::uint32_t mesh = 0;              ///< number of changes of the mesh before
    bool operator==(const LitView&) const = default;
};

/// The orthographic view of `side` x `side` pixels, against the direction `to_light`, that encloses those of
/// `clusters` that belong to the mesh. Has no pixels if none does.
View view_from_light(const PlanScene& scene, std::span<const std::uint32_t> clusters,
                     const Eigen::Vector3d& to_light, int side);

/// The depths of a mesh as seen from the light, in targets.shadows (Williams 1978).
class ShadowMap {
  public:
    /// Finds the clusters that cast shadows in a view. Returns whether the map has to be drawn.
    bool aim(const PlanScene& scene, LitView lit);
    /// Mesh clusters, ascending.
    std::span<const std::uint32_t> casters() const { return casters_; }
    const Eigen::Matrix4f& clip_from_origin() const { return clip_from_origin_; }
    /// From the origin's coordinates to the texture's (x, y) and the stored depth (z).
    Eigen::Matrix4f texture_from_origin(const FrameTargets& targets) const;
    /// Side of a texel, scene units.
    double texel() const;

  private:
    LitView lit_;
    std::vector<std::uint32_t> casters_;
    Eigen::Matrix4f clip_from_origin_ = Eigen::Matrix4f::Zero();
};

}  // namespace vantage
