#include "pipeline/mesh/clusters.h"

#include <meshoptimizer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace vantage {
namespace {

/// The record of a cluster of `count` triangles. Their vertex indices begin at `indices`, and `first` is the
/// number of the first triangle.
package::ClusterRecord bounds(const std::vector<Eigen::Vector3f>& positions, const std::uint32_t* indices,
                              std::uint32_t first, std::uint32_t count) {
    Eigen::Vector3f low = positions[indices[0]], high = low;
    for (std::uint32_t i = 0; i < 3 * count; ++i) {
        low = low.cwiseMin(positions[indices[i]]);
        high = high.cwiseMax(positions[indices[i]]);
    }
    const Eigen::Vector3f center = (low + high) / 2;
    float radius = 0;
    for (std::uint32_t i = 0; i < 3 * count; ++i)
        radius = std::max(radius, (positions[indices[i]] - center).norm());
    const meshopt_Bounds b = meshopt_computeClusterBounds(indices, 3 * count, positions[0].data(),
                                                          positions.size(), sizeof(Eigen::Vector3f));
    const bool has_cone = b.radius > 0;  // 0 if all triangles are degenerate
    return {{center.x(), center.y(), center.z()},
            radius * 1.0001f,
            {b.cone_axis[0], b.cone_axis[1], b.cone_axis[2]},
            has_cone ? b.cone_cutoff : 1.0f,
            first,
            count};
}

using Triangle = std::array<std::uint32_t, 3>;

/// Splits clusters of large triangles until a camera sees each at roughly a single angle and distance;
/// otherwise the player could not estimate a photo's sampling density on it.
class Splitter {
  public:
    Splitter(const std::vector<Eigen::Vector3f>& positions, std::vector<std::uint32_t>& indices,
             const Eigen::AlignedBox3f& scene)
        : positions_(positions),
          triangles_(reinterpret_cast<Triangle*>(indices.data())),
          scene_radius_((scene.max() - scene.min()).norm() / 2) {}
    void split(std::uint32_t first, std::uint32_t count, std::vector<package::ClusterRecord>& out) {
        const package::ClusterRecord c = bounds(positions_, triangles_[first].data(), first, count);
        const std::uint32_t left = count > 1 ? partition(c) : 0;
        if (left == 0 || left == count) {
            out.push_back(c);
        } else {
            split(first, left, out);
            split(first + left, count - left, out);
        }
    }

  private:
    /// Reorders the cluster's triangles into two parts and returns the size of the first part, or 0 to keep
    /// the cluster whole.
    std::uint32_t partition(const package::ClusterRecord& c) {
        constexpr float max_cutoff = 0.87f;  // sine of the cone's half angle
        if (c.radius <= 0.02f * scene_radius_) return 0;
        Triangle *begin = triangles_ + c.first_triangle, *end = begin + c.triangles;
        if (c.cone_cutoff > max_cutoff)
            return partition_at_mean(begin, end, [&](const Triangle& t) { return normal(t); });
        if (c.radius <= 0.1f * scene_radius_) return 0;
        return partition_at_mean(begin, end, [&](const Triangle& t) {
            return Eigen::Vector3f((positions_[t[0]] + positions_[t[1]] + positions_[t[2]]) / 3);
        });
    }
    /// Splits the triangles at the mean of the values, along the axis of largest variance.
    template <class Value>
    static std::uint32_t partition_at_mean(Triangle* begin, Triangle* end, const Value& value) {
        Eigen::Vector3f mean = Eigen::Vector3f::Zero(), variance = mean;
        for (const Triangle* t = begin; t < end; ++t) mean += value(*t) / float(end - begin);
        for (const Triangle* t = begin; t < end; ++t) variance += (value(*t) - mean).cwiseAbs2();
        int axis = 0;
        variance.maxCoeff(&axis);
        return std::uint32_t(std::stable_partition(
                                 begin, end, [&](const Triangle& t) { return value(t)[axis] < mean[axis]; }) -
                             begin);
    }
    Eigen::Vector3f normal(const Triangle& t) const {
        const Eigen::Vector3f a = positions_[t[0]];
        return (positions_[t[1]] - a).cross(positions_[t[2]] - a).normalized();
    }

    const std::vector<Eigen::Vector3f>& positions_;
    Triangle* triangles_;
    float scene_radius_;
};

Eigen::AlignedBox3f box_of(const std::vector<Eigen::Vector3f>& positions) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& p : positions) box.extend(p);
    return box;
}

/// Clamps the positions to the box. The space-filling curve has a fixed resolution: if its range included
/// points far away, all others would fall into one cell.
std::vector<Eigen::Vector3f> clamped(std::vector<Eigen::Vector3f> positions, const Eigen::AlignedBox3f& box) {
    for (Eigen::Vector3f& p : positions) p = p.cwiseMax(box.min()).cwiseMin(box.max()).eval();
    return positions;
}

/// Sorts triangles along a space-filling curve.
void sort_triangles(const std::vector<Eigen::Vector3f>& positions, std::vector<std::uint32_t>& indices) {
    std::vector<std::uint32_t> ordered(indices.size());
    meshopt_spatialSortTriangles(ordered.data(), indices.data(), indices.size(), positions[0].data(),
                                 positions.size(), sizeof(Eigen::Vector3f));
    indices = std::move(ordered);
}

}  // namespace

std::vector<package::ClusterRecord> make_clusters(const std::vector<Eigen::Vector3f>& positions,
                                                  std::vector<std::uint32_t>& indices,
                                                  std::uint32_t cluster_triangles,
                                                  const Eigen::AlignedBox3f& given) {
    std::vector<package::ClusterRecord> clusters;
    if (indices.empty()) return clusters;
    if (given.isEmpty())
        sort_triangles(positions, indices);
    else
        sort_triangles(clamped(positions, given), indices);
    const Eigen::AlignedBox3f scene = given.isEmpty() ? box_of(positions) : given;
    const auto triangles = std::uint32_t(indices.size() / 3);
    Splitter splitter(positions, indices, scene);
    for (std::uint32_t first = 0; first < triangles; first += cluster_triangles)
        splitter.split(first, std::min(cluster_triangles, triangles - first), clusters);
    return clusters;
}

}  // namespace vantage
