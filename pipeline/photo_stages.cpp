#include "pipeline/photo_stages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/file_identity.h"
#include "pipeline/import/photos.h"
#include "pipeline/stages/border.h"
#include "pipeline/stages/clusters.h"
#include "pipeline/stages/coverage.h"
#include "pipeline/stages/masks.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/undistort.h"
#include "pipeline/stages/visibility.h"
#include "scene/checksum.h"

namespace vantage {
namespace {

using package::Type;

RgbaImage read_pixels(const PhotoStages& s, const PhotoInput& photo, package::PhotoRecord& r) {
    const std::vector<std::byte> bytes = read_file(photo.file);
    const FileIdentity id = identify(bytes);
    r.source_bytes = id.bytes;
    r.source_checksum = id.checksum;
    RgbaImage image = decode_photo(photo.file, bytes, photo.decoded);
    const int longest = int(std::max(r.width, r.height));
    if (std::max(image.width, image.height) > longest)
        image = reduced(image, thumbnail_size(image.width, image.height, longest));
    if (!(s.model.record.effects >> int(Effect::undistortion) & 1) || !photo.camera.lens.distorts())
        return image;
    r.flags |= package::photo_undistorted;
    return undistort(image, photo.camera, s.settings.resampling);
}

/// Validity of a level's texels, 0 or 1; empty where the photo is opaque.
std::vector<std::uint8_t> validity(const RgbaImage& level) {
    std::vector<std::uint8_t> valid(level.rgba.size() / 4);
    for (std::size_t p = 0; p < valid.size(); ++p) valid[p] = level.rgba[4 * p + 3] == 255;
    return valid;
}

void write_tiles(PackageWriter& writer, Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size) {
    writer.write_blocks(type, photo, level, [&](std::size_t number, std::span<std::byte> tile) {
        cut_tile(texels, size, number, tile);
    });
}

/// Thumbnail and tile pyramid. Returns the photo's validity at `mask_level`, empty where it is opaque.
std::vector<std::uint8_t> write_pixels(const PhotoStages& s, std::uint32_t i, RgbaImage level,
                                       package::PhotoRecord& r) {
    const bool opaque = is_opaque(level);
    if (!opaque) r.flags |= package::photo_has_alpha;
    std::vector<std::uint8_t> valid;
    bool thumbnail_due = true;
    const std::uint32_t last = std::max(r.levels, std::uint32_t(mask_level) + 1);
    for (std::uint32_t l = 0; l < last; ++l) {
        if (l == std::uint32_t(mask_level) && !opaque) valid = validity(level);
        if (l < r.levels)
            write_tiles(s.writer, Type::tiles, i, l, bytes_of(level.rgba), {level.width, level.height});
        RgbaImage next = halve(level);
        // The coarsest level that still has the thumbnail's detail is the cheapest to reduce.
        const int wanted = int(std::max(r.thumbnail_width, r.thumbnail_height));
        if (thumbnail_due && (std::max(next.width, next.height) < wanted || l + 1 == last)) {
            const RgbaImage small = reduced(level, {int(r.thumbnail_width), int(r.thumbnail_height)});
            s.writer.write(Type::thumbnail, i, std::as_bytes(std::span(small.rgba)));
            thumbnail_due = false;
        }
        level = std::move(next);
    }
    return valid;
}

std::vector<float> distances(const PhotoStages& s, std::vector<std::uint8_t> borders,
                             const PhotoGeometry& g) {
    if (s.distance == DistanceMethod::exact) return exact_distance(borders, g.width, g.height);
    const auto flood = [&] {
        return flood_distance(s.buffers.jump_flood, borders, g.width, g.height, s.distance);
    };
    return s.gl.submit(flood).get();
}

void write_masks(const PhotoStages& s, std::uint32_t i, const PhotoGeometry& g,
                 std::vector<std::uint8_t> valid, const Intrinsics& k, int levels) {
    const DepthMap depth{g.width, g.height, g.z, std::move(valid)};
    const double scale = 1.0 / (1 << mask_level);
    const double full = s.settings.border_width * k.width / 3072 * scale;
    const auto border = border_mask(distances(s, find_borders(depth, float(s.settings.border_threshold)), g),
                                    g.width, g.height, float(full));
    MaskLevel masks{g.width, g.height,
                    combine_masks(g, border, std::sqrt(k.fx * k.fy), s.model.record.reference_density), g.z};
    for (int l = mask_level;; ++l) {
        const Level size{masks.width, masks.height};
        write_tiles(s.writer, Type::masks, i, std::uint32_t(l), bytes_of(masks.masks), size);
        write_tiles(s.writer, Type::depth, i, std::uint32_t(l), bytes_of(masks.z), size);
        if (l + 1 == mask_levels_end(levels)) return;
        masks = halve(masks);
    }
}

void write_coverage(const PhotoStages& s, std::uint32_t i, const FrameTriangles& triangles,
                    const PhotoGeometry& g, const Intrinsics& k, const Pose& pose) {
    const Coverage coverage =
        measure_coverage(s.model.clusters, s.model.indices, triangles.places, g, k, pose);
    s.writer.write(Type::coordinates, i, bytes_of(g.coordinates));
    s.writer.write(Type::coverage, i, bytes_of(coverage.clusters));
    s.writer.write(Type::visible, i, bytes_of(coverage.visible));
}

void record_findings(const PhotoGeometry& g, const Intrinsics& k, const Pose& pose, package::PhotoRecord& r) {
    const SeenHull hull = seen_hull(g.coordinates, k, pose);
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = hull.direction;
    r.hull_area = hull.area;
    const auto seen =
        std::count_if(g.coordinates.begin(), g.coordinates.end(), [](const auto& uv) { return uv.x() >= 0; });
    r.visible_vertices = g.coordinates.empty() ? 0 : double(seen) / double(g.coordinates.size());
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (const float z : g.z) {
        nearest = std::min(nearest, z);
        farthest = std::isinf(z) ? farthest : std::max(farthest, z);
    }
    if (std::isinf(nearest)) return;
    r.z_min = double(nearest);
    r.z_max = double(farthest);
    std::vector<float> some;  // a median needs no more
    for (std::size_t i = 0; i < g.z.size(); i += g.z.size() < 65536 ? 1 : 7)
        if (std::isfinite(g.z[i])) some.push_back(g.z[i]);
    if (some.empty()) some.push_back(nearest);
    const auto middle = some.begin() + std::ptrdiff_t(some.size() / 2);
    std::nth_element(some.begin(), middle, some.end());
    r.seen_distance = double(*middle);
}

}  // namespace

void run_photo(const PhotoStages& s, std::uint32_t i, package::PhotoRecord& r) {
    const PhotoInput& photo = s.scene.photos[i];
    const Intrinsics k = photo.camera.intrinsics;
    const Pose pose = photo.camera.cam_from_world.relative_to(s.model.origin);
    const Eigen::Vector2d range = depth_range(s.model.positions, pose);
    const FrameTriangles triangles = triangles_in_frame(s.model.clusters, s.model.indices, k, pose);
    auto pending = s.gl.submit([&] { return render_geometry(s.buffers, triangles.indices, k, pose, range); });
    std::vector<std::uint8_t> valid;
    try {
        if (r.levels) valid = write_pixels(s, i, read_pixels(s, photo, r), r);
    } catch (...) {
        pending.wait();  // it refers to this frame
        throw;
    }
    PhotoGeometry geometry = pending.get();
    settle_visibility(s.rays.get(), s.model.positions, k, pose, geometry.coordinates);
    record_findings(geometry, k, pose, r);
    if (!r.levels) return;
    write_masks(s, i, geometry, std::move(valid), k, int(r.levels));
    write_coverage(s, i, triangles, geometry, k, pose);
}

}  // namespace vantage
