#include "pipeline/reports/inspect/scale_facts.h"

#include <algorithm>
#include <cmath>

#include "base/values/quantile.h"

namespace vantage {
namespace {

constexpr std::size_t examined = 5000;           ///< approximate number of vertices per photo
constexpr double nearest = 0.1, farthest = 500;  ///< distances of typical photos, m

/// Depths of a sample of the vertices that are in the frame and face the camera.
std::vector<double> depths_in(const PhotoInput& photo, const Mesh& shape) {
    std::vector<double> depths;
    const Pose& pose = photo.camera.cam_from_world;
    const std::size_t step = std::max<std::size_t>(1, shape.positions.size() / examined);
    for (std::size_t v = 0; v < shape.positions.size(); v += step) {
        const auto p = project(photo.camera.intrinsics, pose, shape.positions[v]);
        if (!p || !in_frame(photo.camera.intrinsics, p->pixel)) continue;
        if (!shape.normals.empty() &&
            shape.normals[v].cast<double>().dot(pose.center() - shape.positions[v]) <= 0)
            continue;
        depths.push_back(p->z);
    }
    return depths;
}

}  // namespace

std::optional<ScaleFacts> scale_facts(const SceneInput& scene, double diagonal) {
    const Mesh& shape = has_points_only(scene) ? scene.points : scene.mesh;
    std::vector<double> distances, pixels;
    ScaleFacts facts;
    for (const PhotoInput& photo : scene.photos) {
        const std::vector<double> depths = depths_in(photo, shape);
        if (depths.empty()) continue;
        distances.push_back(quantile(depths, 0.5));
        pixels.push_back(distances.back() /
                         std::sqrt(photo.camera.intrinsics.fx * photo.camera.intrinsics.fy));
        facts.distance.add(distances.back());
    }
    if (distances.empty()) return {};
    facts.typical = quantile(distances, 0.5);
    facts.in_model = diagonal > 0 ? facts.typical / diagonal : 0;
    facts.pixel = quantile(pixels, 0.5);
    return facts;
}

std::vector<std::string> plausible_units(double distance) {
    struct Unit {
        const char* name;
        double meters;
    };
    std::vector<std::string> names;
    for (const Unit& unit : {Unit{"m", 1}, Unit{"cm", 0.01}, Unit{"mm", 0.001}})
        if (distance * unit.meters >= nearest && distance * unit.meters <= farthest)
            names.push_back(unit.name);
    return names;
}

}  // namespace vantage
