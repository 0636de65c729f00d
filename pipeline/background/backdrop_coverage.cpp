#include "pipeline/background/backdrop_coverage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

/// A vertex in a photo.
struct Seen {
    enum : std::uint8_t {
        in_front = 1,  ///< of the camera
        near = 2,      ///< inside the photo or close to it, and close to an open texel
        left = 8,      ///< to the left of the photo
        right = 16,
        above = 32,
        below = 64,
        outside = left | right | above | below
    };
    std::uint8_t is = 0;
    Eigen::Vector2f place = Eigen::Vector2f::Zero();  ///< position in the photo, 0 to 1 inside it
    float density = 0;                                ///< pixels per unit
};

Seen seen_by(const CoarseView& v, std::span<const std::uint8_t> gaps, const Eigen::Vector3f& position) {
    const Eigen::Vector3f p = in_camera(v, position);
    if (!(p.z() > 0)) return {};
    const float x = float(v.k.fx) * p.x() / p.z() + float(v.k.cx),
                y = float(v.k.fy) * p.y() / p.z() + float(v.k.cy);
    Seen s{Seen::in_front, {x / float(v.k.width), y / float(v.k.height)}, float(v.k.fx) / p.z()};
    if (s.place.x() < 0) s.is |= Seen::left;
    if (s.place.x() > 1) s.is |= Seen::right;
    if (s.place.y() < 0) s.is |= Seen::above;
    if (s.place.y() > 1) s.is |= Seen::below;
    if (!(std::abs(x) < 1e6f && std::abs(y) < 1e6f)) return s;
    const int i = int(std::floor(x)), j = int(std::floor(y)), inside_i = std::clamp(i, 0, v.k.width - 1),
              inside_j = std::clamp(j, 0, v.k.height - 1),
              outside = std::max(std::abs(i - inside_i), std::abs(j - inside_j));
    const std::size_t at = std::size_t(inside_j) * std::size_t(v.k.width) + std::size_t(inside_i);
    if (outside <= gap_reach && gaps[at] == 1) s.is |= Seen::near;
    return s;
}

std::uint16_t unorm16(float share) { return std::uint16_t(std::clamp(share, 0.0f, 1.0f) * 65535); }

}  // namespace

std::vector<package::ClusterRecord> backdrop_clusters(const Backdrop& b) {
    std::vector<package::ClusterRecord> out;
    const auto triangles = std::uint32_t(b.sphere.triangles.size());
    for (std::uint32_t first = 0; first < triangles; first += backdrop_cluster) {
        package::ClusterRecord c{};
        c.first_triangle = first;
        c.triangles = std::min(backdrop_cluster, triangles - first);
        Eigen::AlignedBox3f box;
        const auto each = [&](const auto& visit) {
            for (std::uint32_t t = first; t < first + c.triangles; ++t)
                for (const std::uint32_t v : b.sphere.triangles[t]) visit(b.positions[v]);
        };
        each([&](const Eigen::Vector3f& p) { box.extend(p); });
        const Eigen::Vector3f center = box.center();
        float radius2 = 0;
        each([&](const Eigen::Vector3f& p) { radius2 = std::max(radius2, (p - center).squaredNorm()); });
        c.radius = std::sqrt(radius2);
        std::copy_n(center.data(), 3, c.center);
        c.cone_cutoff = 1;
        out.push_back(c);
    }
    return out;
}

std::vector<package::CoverageRecord> backdrop_coverage(const Backdrop& b,
                                                       std::span<const package::ClusterRecord> clusters,
                                                       const CoarseView& view,
                                                       std::span<const std::uint8_t> gaps) {
    std::vector<Seen> seen;
    seen.reserve(b.positions.size());
    for (const Eigen::Vector3f& p : b.positions) seen.push_back(seen_by(view, gaps, p));
    const Eigen::AlignedBox2f frame(Eigen::Vector2f(0, 0), Eigen::Vector2f(1, 1));
    const Eigen::Vector2f large_area(4 / float(view.k.width), 4 / float(view.k.height));
    std::vector<package::CoverageRecord> out;
    for (const package::ClusterRecord& c : clusters) {
        Eigen::AlignedBox2f box;
        std::uint32_t part = 0;
        float density = 0;
        for (std::uint32_t t = c.first_triangle; t < c.first_triangle + c.triangles; ++t) {
            const auto& corners = b.sphere.triangles[t];
            const int x = seen[corners[0]].is, y = seen[corners[1]].is, z = seen[corners[2]].is;
            const int all = x & y & z, any = x | y | z;
            if (!(any & Seen::in_front) || all & Seen::outside) continue;
            Eigen::AlignedBox2f area = frame;  // for a cluster that reaches behind the camera
            if (all & Seen::in_front) {
                area.setEmpty();
                for (const std::uint32_t v : corners) area.extend(seen[v].place);
            }
            // Inside a large cluster, open texels may lie between the corners.
            const bool large = (area.sizes().array() > large_area.array()).any();
            if (!large && !(any & Seen::near)) continue;
            ++part;
            box.extend(area.intersection(frame));
            for (const std::uint32_t v : corners) density = std::max(density, seen[v].density);
        }
        package::CoverageRecord r{};
        if (part > 0) {
            r.seen = std::max<std::uint16_t>(1, unorm16(float(part) / float(c.triangles)));
            const Eigen::Vector2f margin(4 / float(view.k.width), 4 / float(view.k.height));
            const Eigen::Vector2f low = box.min() - margin, high = box.max() + margin;
            r.u0 = unorm16(low.x()), r.v0 = unorm16(low.y()), r.u1 = unorm16(high.x()),
            r.v1 = unorm16(high.y());
        }
        const float level = density > 0 ? std::log2(density) : 0;
        r.log2_density = std::int16_t(std::lround(256 * std::clamp(level, -120.0f, 120.0f)));
        out.push_back(r);
    }
    return out;
}

}  // namespace vantage
