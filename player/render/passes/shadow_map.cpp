#include "player/render/passes/shadow_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "player/plan/cluster_tree.h"

namespace vantage {
namespace {

constexpr int margin = 2;  ///< texels around the enclosed clusters, which the filter may read

/// Number of opaque clusters of the mesh, which precede all others.
std::uint32_t opaque_clusters(const PlanScene& scene) {
    return std::uint32_t(
        std::min<std::size_t>({scene.first_transparent, scene.first_surrounding, scene.clusters.size()}));
}

}  // namespace

View view_from_light(const PlanScene& scene, std::span<const std::uint32_t> clusters,
                     const Eigen::Vector3d& to_light, int side) {
    Eigen::Matrix3d axes;  // right, down and forward
    axes.row(2) = -to_light.normalized();
    axes.row(0) = axes.row(2).unitOrthogonal();
    axes.row(1) = axes.row(2).cross(axes.row(0));
    Eigen::AlignedBox3d bounds;
    for (const std::uint32_t c : clusters) {
        if (c >= scene.first_surrounding) break;
        const Eigen::Vector3d at = axes * center(scene.clusters[c]);
        const Eigen::Vector3d radius = Eigen::Vector3d::Constant(scene.clusters[c].radius);
        bounds.extend(at - radius).extend(at + radius);
    }
    if (bounds.isEmpty() || !(scene.size > 0)) return {};
    const double extent = std::max(bounds.sizes().head<2>().maxCoeff(), 1e-6 * scene.size);
    const double pixels = (side - 2 * margin) / extent;
    const Eigen::Vector3d corner = bounds.min() - Eigen::Vector3d(margin, margin, 0) / pixels;
    return orthographic_view(axes.transpose() * corner, axes.row(0), axes.row(1), pixels, scene.size,
                             {side, side});
}

bool ShadowMap::aim(const PlanScene& scene, LitView lit) {
    if (lit == lit_) return false;
    lit_ = std::move(lit);
    casters_.clear();
    if (lit_.view.intrinsics.width == 0) return false;
    find_clusters_in_view(scene.tree, scene.clusters, lit_.view, casters_);
    casters_.erase(std::ranges::lower_bound(casters_, opaque_clusters(scene)), casters_.end());
    const Eigen::Vector2d range = depth_range(scene.clusters, casters_, lit_.view);
    clip_from_origin_ = vantage::clip_from_origin(lit_.view, range).cast<float>();
    return true;
}

Eigen::Matrix4f ShadowMap::texture_from_origin(const FrameTargets& targets) const {
    const float share = 0.5f * float(lit_.view.intrinsics.width) / float(targets.shadow_side());
    Eigen::Matrix4f texture_from_clip = Eigen::Vector4f(share, share, 1, 1).asDiagonal();
    texture_from_clip(0, 3) = texture_from_clip(1, 3) = share;
    return texture_from_clip * clip_from_origin_;
}

double ShadowMap::texel() const {
    const double pixels = lit_.view.intrinsics.fx / lit_.view.orthographic_depth;
    return pixels > 0 ? 1 / pixels : 0;
}

}  // namespace vantage
