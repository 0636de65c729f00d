#include "player/plan/normal_clusters.h"

#include <algorithm>

namespace vantage {
namespace {

struct Nearest {
    std::size_t cluster;
    double cosine;
};

Nearest nearest(const std::vector<NormalCluster>& clusters, const Eigen::Vector3d& normal) {
    Nearest best{0, -2};
    for (std::size_t c = 0; c < clusters.size(); ++c)
        if (const double cosine = clusters[c].direction.dot(normal); cosine > best.cosine) best = {c, cosine};
    return best;
}

/// Normals, each as far as possible from those before it.
std::vector<NormalCluster> far_apart(const std::vector<Eigen::Vector3d>& normals, std::size_t clusters) {
    std::vector<NormalCluster> out;
    if (!normals.empty() && clusters > 0) out.push_back({normals.front(), 0});
    while (!out.empty() && out.size() < clusters) {
        const auto farthest = std::ranges::min_element(
            normals, {}, [&](const Eigen::Vector3d& n) { return nearest(out, n).cosine; });
        if (nearest(out, *farthest).cosine > 1 - 1e-9) break;
        out.push_back({*farthest, 0});
    }
    return out;
}

}  // namespace

std::vector<NormalCluster> cluster_normals(std::span<const Eigen::Vector3d> all, std::size_t clusters,
                                           int iterations) {
    std::vector<Eigen::Vector3d> normals;
    std::ranges::copy_if(all, std::back_inserter(normals), [](const auto& n) { return n.allFinite(); });
    std::vector<NormalCluster> out = far_apart(normals, clusters);
    for (int i = 0; i < iterations && !out.empty(); ++i) {
        std::vector<Eigen::Vector3d> sums(out.size(), Eigen::Vector3d::Zero());
        for (NormalCluster& c : out) c.members = 0;
        for (const Eigen::Vector3d& n : normals) {
            const std::size_t c = nearest(out, n).cluster;
            sums[c] += n;
            ++out[c].members;
        }
        for (std::size_t c = 0; c < out.size(); ++c)  // opposite normals may cancel out
            if (sums[c].norm() > 1e-9) out[c].direction = sums[c].normalized();
    }
    std::erase_if(out, [](const NormalCluster& c) { return c.members == 0; });
    std::ranges::stable_sort(out, std::ranges::greater{}, &NormalCluster::members);
    return out;
}

}  // namespace vantage
