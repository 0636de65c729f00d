#include "pipeline/mesh/deviation.h"

#include <algorithm>
#include <limits>

#include "pipeline/mesh/nearest_surface.h"
#include "pipeline/run/for_each_photo.h"

namespace vantage {
namespace {

double signed_distance(const NearestSurface& surface, const Eigen::Vector3d& at) {
    const NearestPoint n = surface.nearest(at);
    return n.is_behind(at) ? -n.distance : n.distance;
}

}  // namespace

std::vector<float> deviation(const Mesh& mesh, const Mesh& reference) {
    std::vector<float> out(mesh.positions.size(), std::numeric_limits<float>::quiet_NaN());
    if (reference.positions.empty()) return out;
    const NearestSurface surface(reference);
    constexpr std::size_t vertices_at_once = 1024;
    for_each_photo((out.size() + vertices_at_once - 1) / vertices_at_once, 0, [&](std::size_t part) {
        const std::size_t end = std::min(out.size(), (part + 1) * vertices_at_once);
        for (std::size_t v = part * vertices_at_once; v < end; ++v)
            out[v] = float(signed_distance(surface, mesh.positions[v]));
    });
    return out;
}

}  // namespace vantage
