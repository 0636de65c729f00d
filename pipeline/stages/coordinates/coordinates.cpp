#include "pipeline/stages/coordinates/coordinates.h"

#include <algorithm>

#include "base/values/bytes_of.h"
#include "pipeline/stages/coordinates/depth_summary.h"
#include "pipeline/stages/coordinates/footprint_hull.h"

namespace vantage {

void make_coordinates(StageInput& in) {
    const std::vector<Eigen::Vector2f>& coordinates = in.coordinates();
    package::PhotoRecord& r = in.record;
    const FootprintHull hull = footprint_hull(coordinates, in.photo.intrinsics, in.photo.pose);
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = hull.direction;
    r.hull_area = hull.area;
    const auto seen =
        std::count_if(coordinates.begin(), coordinates.end(), [](const auto& uv) { return uv.x() >= 0; });
    r.visible_vertices = coordinates.empty() ? 0 : double(seen) / double(coordinates.size());
    if (const auto depths = summarize_depths(in.geometry.z)) {
        r.z_min = double(depths->nearest);
        r.z_max = double(depths->farthest);
        r.seen_distance = double(depths->median);
    }
    PackageWriter& writer = in.context.writer;
    if (r.levels && writer.plans(package::Type::coordinates, in.photo.index))
        writer.write(package::Type::coordinates, in.photo.index, bytes_of(coordinates));
}

}  // namespace vantage
