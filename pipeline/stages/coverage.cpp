#include "pipeline/stages/coverage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "scene/tiling.h"

namespace vantage {
namespace {

/// A rectangle of map pixels that grows.
struct Extent {
    int x0 = std::numeric_limits<int>::max(), y0 = x0, x1 = -1, y1 = -1;
    void add(int x, int y) {
        x0 = std::min(x0, x), y0 = std::min(y0, y);
        x1 = std::max(x1, x), y1 = std::max(y1, y);
    }
};

class Bits {
  public:
    Bits(std::vector<std::uint64_t>& words, std::uint64_t first) : words_(words), first_(first) {}
    void set(std::uint32_t i) { words_[first_ + i / 64] |= std::uint64_t(1) << (i % 64); }
    bool at(std::uint32_t i) const { return words_[first_ + i / 64] >> (i % 64) & 1; }

  private:
    std::vector<std::uint64_t>& words_;
    std::uint64_t first_;
};

std::vector<Extent> add_map(const PhotoGeometry& g, const std::vector<FrameTriangles::Place>& places,
                            std::size_t clusters, Bits part) {
    std::vector<Extent> extents(clusters);
    std::size_t i = 0;
    for (int y = 0; y < g.height; ++y)
        for (int x = 0; x < g.width; ++x, ++i) {
            if (g.triangles[i] >= places.size()) continue;
            const FrameTriangles::Place p = places[g.triangles[i]];
            part.set(p.triangle);
            extents[p.cluster].add(x, y);
        }
    return extents;
}

/// Visible vertices count, too: a triangle may lie between the map's pixels.
void add_vertices(const std::vector<std::uint32_t>& indices, const PhotoGeometry& g, const Intrinsics& k,
                  const std::vector<FrameTriangles::Place>& places, std::vector<Extent>& extents, Bits whole,
                  Bits part) {
    for (const FrameTriangles::Place& p : places) {
        int seen = 0;
        for (std::size_t v = 0; v < 3; ++v) {
            const Eigen::Vector2f& uv = g.coordinates[indices[3 * std::size_t(p.triangle) + v]];
            if (uv.x() < 0) continue;
            ++seen;
            extents[p.cluster].add(std::clamp(int(uv.x() * float(k.width)) >> mask_level, 0, g.width - 1),
                                   std::clamp(int(uv.y() * float(k.height)) >> mask_level, 0, g.height - 1));
        }
        if (seen) part.set(p.triangle);
        if (seen == 3) whole.set(p.triangle);
    }
}

std::uint16_t unorm16(double v) { return std::uint16_t(std::clamp(v, 0.0, 65535.0)); }

package::CoverageRecord record(const package::ClusterRecord& c, const Extent& e, const Bits& part,
                               const Intrinsics& k, const Pose& pose) {
    const Eigen::Vector3d center(c.center[0], c.center[1], c.center[2]);
    const double z = (pose.R * center + pose.t).z();
    const double density = z > 0 ? std::log2(std::sqrt(k.fx * k.fy) / z) : 0;
    package::CoverageRecord r{0, 0, 0,
                              0, 0, std::int16_t(std::lround(256 * std::clamp(density, -120.0, 120.0)))};
    if (e.x1 < 0) return r;
    std::uint32_t seen = 0;
    for (std::uint32_t t = c.first_triangle; t < c.first_triangle + c.triangles; ++t) seen += part.at(t);
    r.seen = std::max<std::uint16_t>(1, unorm16(65535.0 * seen / c.triangles));
    // What is seen between two pixels of the map, and what the depth test lets pass, is within two of them.
    const double w = 65535.0 * (1 << mask_level) / k.width, h = 65535.0 * (1 << mask_level) / k.height;
    r.u0 = unorm16(std::floor((e.x0 - 2) * w));
    r.v0 = unorm16(std::floor((e.y0 - 2) * h));
    r.u1 = unorm16(std::ceil((e.x1 + 3) * w));
    r.v1 = unorm16(std::ceil((e.y1 + 3) * h));
    return r;
}

}  // namespace

Coverage measure_coverage(const std::vector<package::ClusterRecord>& clusters,
                          const std::vector<std::uint32_t>& indices,
                          const std::vector<FrameTriangles::Place>& places, const PhotoGeometry& g,
                          const Intrinsics& k, const Pose& pose) {
    const std::uint64_t words = package::visible_words(indices.size() / 3);
    Coverage out{{}, std::vector<std::uint64_t>(2 * words, 0)};
    Bits whole(out.visible, 0), part(out.visible, words);
    std::vector<Extent> extents = add_map(g, places, clusters.size(), part);
    add_vertices(indices, g, k, places, extents, whole, part);
    out.clusters.reserve(clusters.size());
    for (std::size_t c = 0; c < clusters.size(); ++c)
        out.clusters.push_back(record(clusters[c], extents[c], part, k, pose));
    return out;
}

}  // namespace vantage
