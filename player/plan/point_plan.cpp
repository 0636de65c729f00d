#include "player/plan/point_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_set>

#include "player/plan/frustum.h"
#include "scene/camera/camera.h"

namespace vantage {
namespace {

using package::PointNode;

Eigen::Vector3d low_of(const PointNode& n) { return {n.low[0], n.low[1], n.low[2]}; }
Eigen::Vector3d high_of(const PointNode& n) { return low_of(n) + Eigen::Vector3d::Constant(double(n.size)); }

/// The distance in the picture, in pixels, between neighboring points of the node where the node is nearest.
double urgency(const PointNode& n, const Eigen::Vector3d& eye, double focal) {
    const Eigen::Vector3d away = (low_of(n) - eye).cwiseMax(eye - high_of(n)).cwiseMax(0);
    return focal * double(n.spacing) / std::max(away.norm(), double(n.spacing) * 1e-3);
}

}  // namespace

PointPlan plan_points(const PointCloud& cloud, const View& view, std::uint64_t budget, int side,
                      PointCulling culling) {
    PointPlan plan;
    const Frustum planes = frustum(view);
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    const double focal = std::sqrt(view.intrinsics.fx * view.intrinsics.fy);
    std::priority_queue<std::pair<double, std::uint32_t>> waiting;
    const auto consider = [&](std::uint32_t node) {
        const PointNode& n = cloud.nodes[node];
        if (culling == PointCulling::none || side_of(planes, low_of(n), high_of(n)) != Side::outside)
            waiting.emplace(urgency(n, eye, focal), node);
    };
    if (!cloud.nodes.empty()) consider(0);
    while (!waiting.empty()) {
        const auto [apart, node] = waiting.top();
        waiting.pop();
        const PointNode& n = cloud.nodes[node];
        const bool full = plan.points + n.count > budget || plan.nodes.size() == max_point_nodes;
        if (full && !plan.nodes.empty()) {
            plan.whole = false;
            break;
        }
        plan.nodes.push_back(node);
        plan.points += n.count;
        if (apart * side <= 1) continue;
        for (int i = 0; i < std::popcount(n.child_octants); ++i) consider(n.children + std::uint32_t(i));
    }
    return plan;
}

std::vector<DrawnNode> drawn_nodes(const PointCloud& cloud, const PointPlan& plan,
                                   const std::function<bool(std::uint32_t node)>& resident) {
    std::unordered_set<std::uint32_t> usable;
    for (const std::uint32_t node : plan.nodes)
        if (resident(node)) usable.insert(node);
    std::vector<DrawnNode> out;
    if (usable.contains(0)) out.push_back({0, 0, 0});
    for (std::size_t i = 0; i < out.size(); ++i) {
        const PointNode& n = cloud.nodes[out[i].node];
        out[i].first = std::uint32_t(out.size());
        std::uint32_t child = n.children;
        for (unsigned octant = 0; octant < 8; ++octant) {
            if (!(n.child_octants >> octant & 1)) continue;
            if (usable.contains(child)) {
                out[i].children |= 1u << octant;
                out.push_back({child, 0, 0});
            }
            ++child;
        }
    }
    return out;
}

Eigen::Vector2d depth_range(const PointCloud& cloud, const PointPlan& plan, const View& view, double reach) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    const Eigen::RowVector3d axis = view.cam_from_origin.R.row(2);
    for (const std::uint32_t node : plan.nodes) {
        const PointNode& n = cloud.nodes[node];
        const double half = double(n.size) / 2;
        const double middle =
            axis.dot(low_of(n) + Eigen::Vector3d::Constant(half)) + view.cam_from_origin.t.z();
        const double extent = axis.cwiseAbs().sum() * half * (1 + 1e-5);
        if (middle + extent <= 0) continue;
        // Points that fill gaps are drawn up to half a spacing nearer (shaders/point.vert).
        const double lowest = middle - extent;
        nearest = std::min(nearest, std::max(lowest - 0.5 * double(n.spacing), 0.5 * lowest));
        farthest = std::max(farthest, middle + extent);
    }
    return clip_range(nearest, farthest, reach);
}

}  // namespace vantage
