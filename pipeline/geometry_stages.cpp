#include "pipeline/geometry_stages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/stages/border.h"
#include "pipeline/stages/coverage.h"
#include "pipeline/stages/masks.h"
#include "pipeline/stages/visibility.h"
#include "pipeline/trace.h"
#include "pipeline/write_tiles.h"

namespace vantage {
namespace {

using package::Stage;
using package::Type;

void write_masks(const PhotoStages& s, std::uint32_t i, PhotoGeometry g, std::vector<std::uint8_t> valid,
                 const Intrinsics& k, int levels) {
    const Traced traced(s.trace, "masks", s.scene.photos[i].name);
    const DepthMap depth{g.width, g.height, g.z, std::move(valid)};
    const double scale = 1.0 / (1 << mask_level);
    const double full = s.key.settings.border_width * k.width / 3072 * scale;
    const auto borders = find_borders(depth, float(s.key.settings.border_threshold));
    const auto border = border_mask(s.renderer.distances(borders, g.width, g.height, int(full) + 3), g.width,
                                    g.height, float(full));
    auto combined = combine_masks(g, border, std::sqrt(k.fx * k.fy), s.key.reference_density);
    MaskLevel masks{g.width, g.height, std::move(combined), std::move(g.z)};
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
    const Traced traced(s.trace, "coverage", s.scene.photos[i].name);
    const Coverage coverage =
        measure_coverage(s.model.clusters, s.model.indices, triangles.places, g, k, pose);
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

void make_from_geometry(const PhotoRun& run, const Due& due, const FrameTriangles& triangles,
                        PhotoGeometry geometry, std::vector<std::uint8_t> valid, package::PhotoRecord& r) {
    const PhotoStages& s = run.s;
    if (due[Stage::coordinates]) {
        const Traced traced(s.trace, "coordinates", run.photo.name);
        settle_visibility(s.rays.get(), s.model.positions, run.k, run.pose, geometry.coordinates);
        record_findings(geometry, run.k, run.pose, r);
        if (r.levels) s.writer.write(Type::coordinates, run.i, bytes_of(geometry.coordinates));
    }
    if (due[Stage::coverage]) write_coverage(s, run.i, triangles, geometry, run.k, run.pose);
    if (due[Stage::masks]) write_masks(s, run.i, std::move(geometry), std::move(valid), run.k, int(r.levels));
}

}  // namespace vantage
