#include "pipeline/visibility/frame_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace vantage {

FrameTriangles triangles_in_frame(std::span<const package::ClusterRecord> clusters,
                                  std::span<const std::uint32_t> indices, const Intrinsics& k,
                                  const Pose& pose) {
    // Inward unit normals of the view frustum's four side planes, in camera space.
    const Eigen::Vector3d sides[] = {
        Eigen::Vector3d(k.fx, 0, k.cx).normalized(), Eigen::Vector3d(-k.fx, 0, k.width - k.cx).normalized(),
        Eigen::Vector3d(0, k.fy, k.cy).normalized(), Eigen::Vector3d(0, -k.fy, k.height - k.cy).normalized()};
    FrameTriangles out;
    out.indices.reserve(indices.size());
    out.sources.reserve(indices.size() / 3);
    for (std::uint32_t number = 0; number < clusters.size(); ++number) {
        const package::ClusterRecord& c = clusters[number];
        const Eigen::Vector3d center =
            pose.R * Eigen::Map<const Eigen::Vector3f>(c.center).cast<double>() + pose.t;
        const double reach = -double(c.radius) * 1.001;
        if (center.z() < reach || std::any_of(std::begin(sides), std::end(sides),
                                              [&](const auto& n) { return n.dot(center) < reach; }))
            continue;
        const auto first = indices.begin() + std::ptrdiff_t(c.first_triangle) * 3;
        out.indices.insert(out.indices.end(), first, first + std::ptrdiff_t(c.triangles) * 3);
        for (std::uint32_t t = 0; t < c.triangles; ++t) out.sources.push_back({c.first_triangle + t, number});
    }
    return out;
}

}  // namespace vantage
