#include "pipeline/prepare/photo/geometry_stages.h"

#include <algorithm>
#include <cmath>

#include "base/values/bytes_of.h"
#include "pipeline/output/tile_levels.h"
#include "pipeline/stages/borders.h"
#include "pipeline/stages/coverage.h"
#include "pipeline/stages/depth_summary.h"
#include "pipeline/stages/facet_coordinates.h"
#include "pipeline/stages/masks.h"
#include "pipeline/stages/seen_hull.h"
#include "pipeline/stages/vertex_coordinates.h"

namespace vantage {
namespace {

using package::Stage;
using package::Type;

void write_masks(const GeometryContext& c, const PosedPhoto& photo, PhotoGeometry g,
                 std::vector<std::uint8_t> valid, int levels) {
    const Traced traced(c.trace, "masks", photo.name);
    const Intrinsics& k = photo.intrinsics;
    DepthMap depth{g.width, g.height, std::move(g.z), std::move(valid)};
    const double scale = 1.0 / (1 << mask_level);
    const double full = c.border_width * k.width / 3072 * scale;
    const auto borders = find_borders(depth, float(c.border_threshold));
    const auto border = border_mask(c.renderer.distances(borders, g.width, g.height, int(full) + 3), g.width,
                                    g.height, float(full));
    auto combined = combine_masks(depth.z, g.angle, border, std::sqrt(k.fx * k.fy), c.reference_density);
    MaskLevel masks{g.width, g.height, std::move(combined), std::move(depth.z)};
    for (int l = mask_level;; ++l) {
        const Level size{masks.width, masks.height};
        write_tiles(c.writer, Type::masks, photo.index, std::uint32_t(l), bytes_of(masks.masks), size);
        write_tiles(c.writer, Type::depth, photo.index, std::uint32_t(l), bytes_of(masks.z), size);
        if (l + 1 == mask_levels_end(levels)) return;
        masks = halve(masks);
    }
}

void write_coverage(const GeometryContext& c, const PosedPhoto& photo, const FrameTriangles& triangles,
                    const PhotoGeometry& g, const std::vector<Eigen::Vector2f>& coordinates) {
    const Traced traced(c.trace, "coverage", photo.name);
    const Coverage coverage = measure_coverage(c.model.clusters, c.model.indices, triangles.sources, g,
                                               coordinates, photo.intrinsics, photo.pose);
    c.writer.write(Type::coverage, photo.index, bytes_of(coverage.clusters));
    c.writer.write(Type::visible, photo.index, bytes_of(coverage.visible));
}

void write_samples(const GeometryContext& c, const PosedPhoto& photo, const PhotoGeometry& g,
                   RgbaImage pixels) {
    const Traced traced(c.trace, "samples", photo.name);
    const auto samples = sample_discs(c.discs, std::move(pixels), g, photo.intrinsics, photo.pose,
                                      photo.lens ? &*photo.lens : nullptr);
    c.writer.write(Type::samples, photo.index, bytes_of(samples));
}

void record_findings(const PhotoGeometry& g, const std::vector<Eigen::Vector2f>& coordinates,
                     const Intrinsics& k, const Pose& pose, package::PhotoRecord& r) {
    const SeenHull hull = seen_hull(coordinates, k, pose);
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = hull.direction;
    r.hull_area = hull.area;
    const auto seen =
        std::count_if(coordinates.begin(), coordinates.end(), [](const auto& uv) { return uv.x() >= 0; });
    r.visible_vertices = coordinates.empty() ? 0 : double(seen) / double(coordinates.size());
    if (const auto depths = summarize_depths(g.z)) {
        r.z_min = double(depths->nearest);
        r.z_max = double(depths->farthest);
        r.seen_distance = double(depths->median);
    }
}

}  // namespace

std::vector<std::uint8_t> validity(const RgbaImage& level) {
    std::vector<std::uint8_t> valid(level.rgba.size() / 4);
    for (std::size_t p = 0; p < valid.size(); ++p) valid[p] = level.rgba[4 * p + 3] == 255;
    return valid;
}

PhotoView view_of(const GeometryContext& c, const PosedPhoto& photo) {
    const Traced traced(c.trace, "project", photo.name);
    const Eigen::Vector2d near_far =
        depth_range(c.model.opaque_positions(), photo.pose, model_reach(c.model.record, photo.pose));
    return {triangles_in_frame(c.model.opaque_clusters(), c.model.indices, photo.intrinsics, photo.pose),
            near_far,
            project_model(c.model.opaque_positions(), map_intrinsics(photo.intrinsics), photo.pose,
                          near_far.x())};
}

void make_from_geometry(const GeometryContext& c, const PosedPhoto& photo, const StageSet& missing,
                        const PhotoView& view, PhotoGeometry geometry, std::future<CoarsePixels> pixels,
                        package::PhotoRecord& r) {
    if (missing[Stage::coordinates] || missing[Stage::coverage]) {
        const auto coordinates = [&] {
            const Traced traced(c.trace, "coordinates", photo.name);
            if (c.renderer.cloud())
                return facet_coordinates(view.projection, c.model.indices, geometry, photo.intrinsics);
            auto seen = vertex_coordinates(view.projection, view.triangles.indices, photo.intrinsics);
            seen.resize(c.model.positions.size(), Eigen::Vector2f(-1, -1));  // photos look through the others
            return seen;
        }();
        if (missing[Stage::coordinates]) {
            record_findings(geometry, coordinates, photo.intrinsics, photo.pose, r);
            if (r.levels && c.writer.plans(Type::coordinates, photo.index))
                c.writer.write(Type::coordinates, photo.index, bytes_of(coordinates));
        }
        if (missing[Stage::coverage]) write_coverage(c, photo, view.triangles, geometry, coordinates);
    }
    if (!missing[Stage::masks] && !missing[Stage::samples]) return;
    CoarsePixels coarse = pixels.get();
    if (missing[Stage::samples]) write_samples(c, photo, geometry, std::move(coarse.samples));
    if (!missing[Stage::masks]) return;
    if (coarse.valid.empty() && photo.lens) coarse.valid = inside_photo(*photo.lens, mask_level);
    write_masks(c, photo, std::move(geometry), std::move(coarse.valid), int(r.levels));
}

}  // namespace vantage
