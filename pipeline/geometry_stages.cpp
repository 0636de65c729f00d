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

void write_masks(const PhotoStages& s, std::uint32_t i, PhotoGeometry g, std::vector<std::uint8_t> valid,
                 const Intrinsics& k, int levels) {
    const Traced traced(s.trace, "masks", s.scene.photos[i].name);
    DepthMap depth{g.width, g.height, std::move(g.z), std::move(valid)};
    const double scale = 1.0 / (1 << mask_level);
    const double full = s.key.settings.border_width * k.width / 3072 * scale;
    const auto borders = find_borders(depth, float(s.key.settings.border_threshold));
    const auto border = border_mask(s.renderer.distances(borders, g.width, g.height, int(full) + 3), g.width,
                                    g.height, float(full));
    auto combined = combine_masks(depth.z, g.angle, border, std::sqrt(k.fx * k.fy), s.key.reference_density);
    MaskLevel masks{g.width, g.height, std::move(combined), std::move(depth.z)};
    for (int l = mask_level;; ++l) {
        const Level size{masks.width, masks.height};
        write_tiles(s.writer, Type::masks, i, std::uint32_t(l), bytes_of(masks.masks), size);
        write_tiles(s.writer, Type::depth, i, std::uint32_t(l), bytes_of(masks.z), size);
        if (l + 1 == mask_levels_end(levels)) return;
        masks = halve(masks);
    }
}

void write_coverage(const PhotoRun& run, const FrameTriangles& triangles, const PhotoGeometry& g,
                    const std::vector<Eigen::Vector2f>& coordinates) {
    const PhotoStages& s = run.s;
    const Traced traced(s.trace, "coverage", run.photo.name);
    const Coverage coverage = measure_coverage(s.model.clusters, s.model.indices, triangles.places, g,
                                               coordinates, run.k, run.pose);
    s.writer.write(Type::coverage, run.i, bytes_of(coverage.clusters));
    s.writer.write(Type::visible, run.i, bytes_of(coverage.visible));
}

void write_samples(const PhotoRun& run, const PhotoGeometry& g, RgbaImage photo) {
    const Traced traced(run.s.trace, "samples", run.photo.name);
    const auto samples = sample_discs(run.s.discs, std::move(photo), g, run.k, run.pose);
    run.s.writer.write(Type::samples, run.i, bytes_of(samples));
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

PhotoView view_of(const PhotoRun& run) {
    const PackedModel& model = run.s.model;
    const Traced traced(run.s.trace, "project", run.photo.name);
    const Eigen::Vector2d near_far = depth_range(model.positions, run.pose);
    return {triangles_in_frame(model.clusters, model.indices, run.k, run.pose), near_far,
            project_model(model.positions, map_intrinsics(run.k), run.pose, near_far.x())};
}

void make_from_geometry(const PhotoRun& run, const Due& due, const PhotoView& view, PhotoGeometry geometry,
                        std::future<CoarsePixels> pixels, package::PhotoRecord& r) {
    const PhotoStages& s = run.s;
    if (due[Stage::coordinates] || due[Stage::coverage]) {
        const auto coordinates = [&] {
            const Traced traced(s.trace, "coordinates", run.photo.name);
            return vertex_coordinates(view.projection, view.triangles.indices, run.k);
        }();
        if (due[Stage::coordinates]) {
            record_findings(geometry, coordinates, run.k, run.pose, r);
            if (r.levels) s.writer.write(Type::coordinates, run.i, bytes_of(coordinates));
        }
        if (due[Stage::coverage]) write_coverage(run, view.triangles, geometry, coordinates);
    }
    if (!due[Stage::masks] && !due[Stage::samples]) return;
    CoarsePixels coarse = pixels.get();
    if (due[Stage::samples]) write_samples(run, geometry, std::move(coarse.samples));
    if (due[Stage::masks])
        write_masks(s, run.i, std::move(geometry), std::move(coarse.valid), run.k, int(r.levels));
}

}  // namespace vantage
