#include "pipeline/stages/coordinates/facet_coordinates.h"

#include <algorithm>

#include "pipeline/mesh/stand_in.h"

namespace vantage {

std::vector<Eigen::Vector2f> facet_coordinates(const PhotoProjection& projection,
                                               std::span<const std::uint32_t> indices,
                                               const PhotoGeometry& maps, const Intrinsics& photo) {
    const double slack = facet_size(projection.positions, indices);
    std::vector<Eigen::Vector2f> out(projection.positions.size(), Eigen::Vector2f(-1, -1));
    for (std::uint32_t v = 0; v < out.size(); ++v) {
        const auto at = project(photo, Pose{}, projection.in_camera(v));
        if (!at) continue;
        const Eigen::Vector2d uv = at->pixel.cwiseQuotient(Eigen::Vector2d(photo.width, photo.height));
        if (!(uv.minCoeff() >= 0 && uv.maxCoeff() < 1)) continue;
        const auto x = std::min(int(uv.x() * maps.width), maps.width - 1),
                   y = std::min(int(uv.y() * maps.height), maps.height - 1);
        const float z = maps.z[std::size_t(y) * std::size_t(maps.width) + std::size_t(x)];
        if (at->z <= double(z) + slack && z < std::numeric_limits<float>::infinity())
            out[v] = uv.cast<float>().cwiseMin(1.0f);
    }
    return out;
}

}  // namespace vantage
