// Tests on random clouds, views and boxes that no visible point is culled and that stored positions have the
// accuracy stated in FORMAT.md.
#include "scene/package/contents/point_cloud.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "pipeline/mesh/point_tree.h"
#include "player/plan/frustum.h"
#include "player/plan/point_plan.h"

using namespace vantage;

namespace {

/// A number in [-1, 1].
double share() { return *rc::gen::inRange(-1'000'000, 1'000'001) / 1e6; }
Eigen::Vector3d vector() { return {share(), share(), share()}; }

/// A random view from inside or around a cube of this size centered at the origin, with any direction and
/// focal length.
View view(double size) {
    const Eigen::Vector3d eye = 2 * size * vector(), aside = size * (vector() + Eigen::Vector3d(1.1, 0, 0));
    const int width = *rc::gen::inRange(1, 2000), height = *rc::gen::inRange(1, 2000);
    View v = view_towards(eye, eye + aside, vector() + Eigen::Vector3d(0, 0, 1.5), 90 + 85 * share(), width,
                          height);
    v.intrinsics.cx += width * share();
    v.intrinsics.cy += height * share();
    return v;
}

bool is_shown(const View& v, const Eigen::Vector3d& p) {
    const auto at = project(v.intrinsics, v.cam_from_origin, p);
    return at && at->z > 0 && at->pixel.x() >= 0 && at->pixel.y() >= 0 &&
           at->pixel.x() < v.intrinsics.width && at->pixel.y() < v.intrinsics.height;
}

}  // namespace

RC_GTEST_PROP(PointCulling, NoVisiblePointIsCulled, ()) {
    const double size = std::exp2(20 * share());
    const int count = *rc::gen::inRange(1, 40'000);
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    Mesh cloud;
    // Half of the points are on a sheet, and the others are randomly distributed.
    std::uint64_t state = seed;
    const auto next = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return (double(state >> 33) / double(1u << 30) - 1) * size;
    };
    for (int i = 0; i < count; ++i) {
        const double x = next(), y = next(), z = next();
        cloud.positions.emplace_back(x, y, i % 2 ? 0.2 * x + 0.01 * z : z);
    }
    const PointTree tree = make_point_tree(cloud, Eigen::Vector3d::Zero());
    PointCloud points{tree.nodes, tree.blocks, std::uint64_t(count)};
    const View v = view(size);
    constexpr std::uint64_t all = 1'000'000'000;
    const PointPlan plan = plan_points(points, v, all, 1 << 20);
    const std::set<std::uint32_t> planned(plan.nodes.begin(), plan.nodes.end());
    RC_ASSERT(plan.whole);
    std::size_t shown = 0;
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
        for (std::uint32_t i = 0; i < tree.nodes[n].count; ++i) {
            if (!is_shown(v, cloud.positions[tree.order[tree.starts[n] + i]])) continue;
            ++shown;
            RC_ASSERT(planned.contains(n));
        }
    RC_CLASSIFY(shown > 0, "points in view");
}

RC_GTEST_PROP(PointCulling, ABoxWithAVisiblePointIsNotOutside, ()) {
    const double size = std::exp2(30 * share());
    const View v = view(size);
    const Frustum planes = frustum(v);
    const Eigen::Vector3d a = 2 * size * vector(), b = 2 * size * vector(), low = a.cwiseMin(b),
                          high = a.cwiseMax(b);
    const Side side = side_of(planes, low, high);
    bool any = false, all = true;
    for (int i = 0; i < 64; ++i) {
        const Eigen::Vector3d at = (Eigen::Vector3d::Ones() + vector()) / 2,
                              p = low + at.cwiseProduct(high - low);
        const bool shown = is_shown(v, p);
        any |= shown, all &= shown;
    }
    RC_ASSERT(!(any && side == Side::outside));
    RC_ASSERT(!(!all && side == Side::inside));
    RC_CLASSIFY(any, "visible");
}

RC_GTEST_PROP(PointStorage, PositionsAreOffByHalfACellAtMost, ()) {
    package::PointNode node{};
    const double size = std::exp2(40 * share());
    node.size = float(size);
    for (float& low : node.low) low = float(1000 * size * share());
    Eigen::Vector3d p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = double(node.low[axis]) + (share() + 1) / 2 * double(node.size);
    const Eigen::Vector3d back = unpacked(packed(p, node), node);
    // According to FORMAT.md, a stored position is the middle of one of 2^21 cells along each axis; any
    // further error is due to rounding in double precision.
    const double half = double(node.size) / (1 << 22), rounding = 1e-12 * size * 1001;
    RC_ASSERT((back - p).cwiseAbs().maxCoeff() <= half + rounding);
    const package::PackedPoint again = packed(back, node), before = packed(p, node);
    RC_ASSERT(again.low == before.low && again.high == before.high);
}
