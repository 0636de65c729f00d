#include "pipeline/stages/coverage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/values/bytes_of.h"
#include "base/values/grid.h"
#include "base/values/tiling.h"
#include "pipeline/visibility/frame_triangles.h"

namespace vantage {
namespace {

/// Bounding rectangle of map pixels.
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

struct Found {
    std::vector<std::uint8_t> on_map;  ///< per triangle: whether the map shows it
    std::vector<Extent> extents;       ///< per cluster
    Bits whole, part;                  ///< triangles seen
};

/// Marks the triangles in the photo's triangle map and extends their clusters' rectangles.
void add_map(const PhotoGeometry& g, const std::vector<FrameTriangles::Source>& sources, Found& found) {
    const Grid<const std::uint32_t> map{g.triangles.data(), g.width, g.height};
    for (int y = 0; y < g.height; ++y) {
        const std::span<const std::uint32_t> row = map.row(y);
        std::uint32_t cluster = 0;
        int first = 0, last = -1;  // ends of the current run of pixels of `cluster`
        const auto add = [&] {
            if (last >= 0) found.extents[cluster].add(first, y), found.extents[cluster].add(last, y);
        };
        for (int x = 0; x < g.width; ++x) {
            const std::uint32_t triangle = row[std::size_t(x)];
            if (triangle >= sources.size()) continue;
            found.on_map[triangle] = 1;
            if (const std::uint32_t c = sources[triangle].cluster; c != cluster || last < 0)
                add(), cluster = c, first = x;
            last = x;
        }
        add();
    }
}

/// Adds triangles with visible vertices, since a triangle may fall between the map's pixels. Triangles of one
/// cluster are consecutive in `sources`.
void add_vertices(const std::vector<std::uint32_t>& indices, const PhotoGeometry& g,
                  const std::vector<Eigen::Vector2f>& coordinates, const Intrinsics& k,
                  const std::vector<FrameTriangles::Source>& sources, Found& found) {
    const Eigen::Vector2f size(float(k.width), float(k.height));
    const auto add = [&](std::uint32_t cluster, const Eigen::Vector2f& uv) {
        const Eigen::Vector2i p = uv.cwiseProduct(size).cast<int>() / (1 << weight_map_level);
        found.extents[cluster].add(std::clamp(p.x(), 0, g.width - 1), std::clamp(p.y(), 0, g.height - 1));
    };
    for (std::size_t i = 0; i < sources.size();) {
        const std::uint32_t cluster = sources[i].cluster;
        const Eigen::Vector2f outside(2, 2);
        Eigen::Vector2f low = outside, high(-1, -1);
        for (; i < sources.size() && sources[i].cluster == cluster; ++i) {
            const std::uint32_t* corners = &indices[3 * std::size_t(sources[i].triangle)];
            int seen = 0;
            for (int v = 0; v < 3; ++v) {
                const Eigen::Vector2f& uv = coordinates[corners[v]];
                const bool visible = uv.x() >= 0;
                seen += visible;
                low = low.cwiseMin(visible ? uv : outside);
                high = high.cwiseMax(uv);
            }
            if (seen || found.on_map[i]) found.part.set(sources[i].triangle);
            if (seen == 3) found.whole.set(sources[i].triangle);
        }
        if (high.x() >= 0) add(cluster, low), add(cluster, high);
    }
}

std::uint16_t clamped_u16(double v) { return std::uint16_t(std::clamp(v, 0.0, 65535.0)); }

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
    r.seen = std::max<std::uint16_t>(1, clamped_u16(65535.0 * seen / c.triangles));
    // A margin of two pixels covers triangles that fall between pixels, and triangles that pass the player's
    // depth test.
    const double w = 65535.0 * (1 << weight_map_level) / k.width,
                 h = 65535.0 * (1 << weight_map_level) / k.height;
    r.u0 = clamped_u16(std::floor((e.x0 - 2) * w));
    r.v0 = clamped_u16(std::floor((e.y0 - 2) * h));
    r.u1 = clamped_u16(std::ceil((e.x1 + 3) * w));
    r.v1 = clamped_u16(std::ceil((e.y1 + 3) * h));
    return r;
}

}  // namespace

void make_coverage(StageInput& in) {
    const std::vector<Eigen::Vector2f>& coordinates = in.coordinates();
    const Traced traced(in.context.trace, "coverage", in.photo.name);
    const PackedModel& model = in.context.model;
    const Intrinsics& k = in.photo.intrinsics;
    const std::vector<FrameTriangles::Source>& sources = in.view.triangles.sources;
    const std::uint64_t words = package::visible_words(model.indices.size() / 3);
    std::vector<std::uint64_t> visible(2 * words, 0);
    Found found{std::vector<std::uint8_t>(sources.size(), 0), std::vector<Extent>(model.clusters.size()),
                Bits(visible, 0), Bits(visible, words)};
    add_map(in.geometry, sources, found);
    add_vertices(model.indices, in.geometry, coordinates, k, sources, found);
    std::vector<package::CoverageRecord> clusters;
    clusters.reserve(found.extents.size());
    for (std::size_t c = 0; c < found.extents.size(); ++c)
        clusters.push_back(record(model.clusters[c], found.extents[c], found.part, k, in.photo.pose));
    in.context.writer.write(package::Type::coverage, in.photo.index, bytes_of(clusters));
    in.context.writer.write(package::Type::visible, in.photo.index, bytes_of(visible));
}

}  // namespace vantage
