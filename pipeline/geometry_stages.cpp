#include "pipeline/geometry_stages.h"

#include <algorithm>
#include <cmath>

#include "pipeline/stages/border.h"
#include "pipeline/stages/coverage.h"
#include "pipeline/stages/depth_summary.h"
#include "pipeline/stages/masks.h"
#include "pipeline/stages/seen_hull.h"
#include "pipeline/stages/surface_samples.h"
#include "pipeline/stages/vertex_coordinates.h"
#include "pipeline/trace.h"
#include "pipeline/write_tiles.h"

namespace vantage {
namespace {

using package::Stage;
using package::Type;

void write_masks(const GeometryStages& s, const PhotoAtModel& photo, PhotoGeometry g,
                 std::vector<std::uint8_t> valid, int levels) {
    const Traced traced(s.trace, "masks", photo.name);
    DepthMap depth{g.width, g.height, std::move(g.z), std::move(valid)};
    const double scale = 1.0 / (1 << mask_level);
    const double full = s.border_width * photo.k.width / 3072 * scale;
    const auto borders = find_borders(depth, float(s.border_threshold));
    const auto border = border_mask(s.renderer.distances(borders, g.width, g.height, int(full) + 3), g.width,
                                    g.height, float(full));
    auto combined = combine_masks(depth.z, g.angle, border, std::sqrt(photo.k.fx * photo.k.fy),
                                  s.model.record.reference_density);
    MaskLevel masks{g.width, g.height, std::move(combined), std::move(depth.z)};
    for (int l = mask_level;; ++l) {
        const Level size{masks.width, masks.height};
        write_tiles(s.writer, Type::masks, photo.i, std::uint32_t(l), bytes_of(masks.masks), size);
        write_tiles(s.writer, Type::depth, photo.i, std::uint32_t(l), bytes_of(masks.z), size);
        if (l + 1 == mask_levels_end(levels)) return;
        masks = halve(masks);
    }
}

void write_coverage(const GeometryStages& s, const PhotoAtModel& photo, const FrameTriangles& triangles,
                    const PhotoGeometry& g, const std::vector<Eigen::Vector2f>& coordinates) {
    const Traced traced(s.trace, "coverage", photo.name);
    const Coverage coverage = measure_coverage(s.model.clusters, s.model.indices, triangles.places, g,
                                               coordinates, photo.k, photo.pose);
    s.writer.write(Type::coverage, photo.i, bytes_of(coverage.clusters));
    s.writer.write(Type::visible, photo.i, bytes_of(coverage.visible));
}

void write_samples(const GeometryStages& s, const PhotoAtModel& photo, const PhotoGeometry& g,
                   RgbaImage pixels) {
    const Traced traced(s.trace, "samples", photo.name);
    s.writer.write(Type::samples, photo.i,
                   bytes_of(sample_discs(s.discs, std::move(pixels), g, photo.k, photo.pose)));
}

void record_findings(const PhotoGeometry& g, const std::vector<Eigen::Vector2f>& coordinates,
                     const Intrinsics& k, const Pose& pose, package::PhotoRecord& r) {
    const SeenHull hull = seen_hull(coordinates, k, pose);
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = hull.direction;
    r.hull_area = hull.area;
    const auto seen =
        std::count_if(coordinates.begin(), coordinates.end(), [](const auto& uv) { return uv.x() >= 0; });
    r.visible_vertices = coordinates.empty() ? 0 : double(seen) / double(coordinates.size());
    if (const auto depths = summarise_depths(g.z)) {
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

PhotoView view_of(const GeometryStages& s, const PhotoAtModel& photo) {
    const Traced traced(s.trace, "project", photo.name);
    const Eigen::Vector2d near_far = depth_range(s.model.positions, photo.pose);
    return {triangles_in_frame(s.model.clusters, s.model.indices, photo.k, photo.pose), near_far,
            project_model(s.model.positions, map_intrinsics(photo.k), photo.pose, near_far.x())};
}

void make_from_geometry(const GeometryStages& s, const PhotoAtModel& photo, const Due& due,
                        const PhotoView& view, PhotoGeometry geometry, std::future<CoarsePixels> pixels,
                        package::PhotoRecord& r) {
    if (due[Stage::coordinates] || due[Stage::coverage]) {
        const auto coordinates = [&] {
            const Traced traced(s.trace, "coordinates", photo.name);
            return vertex_coordinates(view.projection, view.triangles.indices, photo.k);
        }();
        if (due[Stage::coordinates]) {
            record_findings(geometry, coordinates, photo.k, photo.pose, r);
            if (r.levels) s.writer.write(Type::coordinates, photo.i, bytes_of(coordinates));
        }
        if (due[Stage::coverage]) write_coverage(s, photo, view.triangles, geometry, coordinates);
    }
    if (!due[Stage::masks] && !due[Stage::samples]) return;
    CoarsePixels coarse = pixels.get();
    if (due[Stage::samples]) write_samples(s, photo, geometry, std::move(coarse.samples));
    if (due[Stage::masks]) write_masks(s, photo, std::move(geometry), std::move(coarse.valid), int(r.levels));
}

}  // namespace vantage
