#include "player/tile_needs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "scene/package_reader.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

/// A rectangle of photo pixels at full size.
struct Rect {
    double u0, v0, u1, v1;
};

Eigen::Vector3d in_camera(const package::ClusterRecord& c, const Pose& pose) {
    return pose.R * Eigen::Vector3d(c.center[0], c.center[1], c.center[2]) + pose.t;
}

/// Bounds of (x ± r) / (z ± r): what a sphere's box can project to. Needs z > r.
Eigen::Vector2d slopes(double x, double z, double r) {
    return {std::min((x - r) / (z - r), (x - r) / (z + r)), std::max((x + r) / (z - r), (x + r) / (z + r))};
}

std::optional<Rect> sphere_rect(const Eigen::Vector3d& p, double r, const package::PhotoRecord& photo) {
    if (p.z() + r <= 0) return std::nullopt;
    Rect rect{0, 0, double(photo.width), double(photo.height)};
    if (p.z() - r > 1e-6 * r) {
        const Eigen::Vector2d x = slopes(p.x(), p.z(), r), y = slopes(p.y(), p.z(), r);
        rect = {std::max(0.0, photo.fx * x[0] + photo.cx), std::max(0.0, photo.fy * y[0] + photo.cy),
                std::min(rect.u1, photo.fx * x[1] + photo.cx), std::min(rect.v1, photo.fy * y[1] + photo.cy)};
    }
    if (rect.u0 >= rect.u1 || rect.v0 >= rect.v1) return std::nullopt;
    return rect;
}

std::optional<Rect> seen_rect(const package::CoverageRecord& c, const package::PhotoRecord& photo) {
    if (c.seen == 0) return std::nullopt;
    const double w = photo.width / 65535.0, h = photo.height / 65535.0;
    return Rect{(c.u0 - 1) * w, (c.v0 - 1) * h, (c.u1 + 1) * w, (c.v1 + 1) * h};
}

/// The finest level that any fragment of the cluster may sample. One level is given away to foreshortening in
/// the photo, which the shader's footprint follows.
int finest_level(const package::PhotoRecord& photo, const Eigen::Vector3d& in_photo,
                 const Eigen::Vector3d& in_view, double r, const View& view, int samples) {
    const double far_in_photo = in_photo.z() + r, near_in_view = in_view.z() - r;
    if (near_in_view <= 0) return 0;
    const double photo_density = std::min(photo.fx, photo.fy) / far_in_photo;
    const double view_density = std::max(view.intrinsics.fx, view.intrinsics.fy) * samples / near_in_view;
    const double lod = std::log2(photo_density / view_density) - 1;
    return std::isfinite(lod) ? int(std::clamp(lod, 0.0, double(photo.levels) - 1)) : 0;
}

void mark(std::vector<bool>& tiles, const Level& size, const Rect& rect, int level) {
    const double s = 1.0 / (1 << level);
    const auto tile = [](double texel, int count) {
        return int(std::clamp(std::floor(texel / tile_content), 0.0, double(count - 1)));
    };
    const int x0 = tile(rect.u0 * s - 1, size.columns()), x1 = tile(rect.u1 * s + 1, size.columns());
    const int y0 = tile(rect.v0 * s - 1, size.rows()), y1 = tile(rect.v1 * s + 1, size.rows());
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            tiles[std::size_t(y) * std::size_t(size.columns()) + std::size_t(x)] = true;
}

std::vector<std::uint32_t> listed(const std::vector<bool>& marks) {
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (marks[i]) out.push_back(std::uint32_t(i));
    return out;
}

}  // namespace

std::vector<std::uint32_t> clusters_in_view(std::span<const package::ClusterRecord> clusters,
                                            const View& view) {
    const Intrinsics& k = view.intrinsics;
    // Inward normals of the frustum's sides, which all pass through the eye.
    const std::array<Eigen::Vector3d, 4> sides{
        Eigen::Vector3d(k.fx, 0, k.cx).normalized(), Eigen::Vector3d(-k.fx, 0, k.width - k.cx).normalized(),
        Eigen::Vector3d(0, k.fy, k.cy).normalized(), Eigen::Vector3d(0, -k.fy, k.height - k.cy).normalized()};
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < clusters.size(); ++i) {
        const Eigen::Vector3d p = in_camera(clusters[i], view.cam_from_origin);
        const double r = clusters[i].radius * (1 + 1e-5);
        if (p.z() + r > 0 &&
            std::all_of(sides.begin(), sides.end(), [&](const auto& n) { return n.dot(p) >= -r; }))
            out.push_back(i);
    }
    return out;
}

Eigen::Vector2d depth_range(std::span<const package::ClusterRecord> clusters, const View& view) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const package::ClusterRecord& c : clusters) {
        const double z = in_camera(c, view.cam_from_origin).z();
        if (z + c.radius <= 0) continue;
        nearest = std::min(nearest, z - c.radius);
        farthest = std::max(farthest, z + c.radius);
    }
    if (!(farthest > 0)) return {0, 0};
    return {std::max(nearest * 0.999, farthest * 1e-5), farthest * 1.001};
}

std::size_t TileNeeds::tiles() const {
    std::size_t n = 0;
    for (const auto& level : color) n += level.size();
    return n;
}

TileNeeds tile_needs(const package::PhotoRecord& photo, std::span<const package::ClusterRecord> clusters,
                     std::span<const package::CoverageRecord> coverage,
                     std::span<const std::uint32_t> in_view, const View& view, int samples) {
    const int width = int(photo.width), height = int(photo.height);
    std::vector<Level> sizes;
    std::vector<std::vector<bool>> marks;
    for (int l = 0; l < int(photo.levels); ++l) {
        sizes.push_back(level_size(width, height, l));
        marks.emplace_back(std::size_t(sizes.back().tiles()), false);
    }
    const Level mask_size = level_size(width, height, mask_level);
    std::vector<bool> mask_marks(std::size_t(mask_size.tiles()), false);
    const Pose pose = cam_from_origin(photo);
    for (const std::uint32_t i : in_view) {
        const Eigen::Vector3d p = in_camera(clusters[i], pose);
        const double r = clusters[i].radius;
        const auto rect = coverage.empty() ? sphere_rect(p, r, photo) : seen_rect(coverage[i], photo);
        if (!rect) continue;
        const int finest =
            finest_level(photo, p, in_camera(clusters[i], view.cam_from_origin), r, view, samples);
        for (int l = finest; l < int(photo.levels); ++l)
            mark(marks[std::size_t(l)], sizes[std::size_t(l)], *rect, l);
        mark(mask_marks, mask_size, *rect, mask_level);
    }
    TileNeeds needs;
    for (std::size_t l = 0; l < marks.size(); ++l) needs.color[l] = listed(marks[l]);
    needs.masks = listed(mask_marks);
    return needs;
}

void append_requests(const PackageReader& package, std::uint32_t photo, const PhotoBlock& pages,
                     const TileNeeds& needs, TileRequests& out) {
    const auto append = [&](package::Type type, std::uint32_t level, std::uint32_t base,
                            const std::vector<std::uint32_t>& tiles, std::vector<TileRequest>& list) {
        const package::DirectoryEntry* chunk = package.find(type, photo, level);
        for (const std::uint32_t t : tiles) list.push_back({chunk, t, base + t});
    };
    for (std::uint32_t l = most_levels; l-- > 0;)
        append(package::Type::tiles, l, pages.level_base[l], needs.color[l], out.color);
    append(package::Type::masks, std::uint32_t(mask_level), pages.mask_base, needs.masks, out.masks);
    append(package::Type::depth, std::uint32_t(mask_level), pages.mask_base, needs.masks, out.depth);
}

}  // namespace vantage
