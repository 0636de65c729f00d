#include "pipeline/stages/mesh_in_view.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/text/error.h"
#include "base/values/main_box.h"

namespace vantage {
namespace {

constexpr std::size_t max_examined = 200000;  ///< vertices per photo

/// Whether the vertices in the frame span a large enough part of it. Vertices are visited in large steps, so
/// that a few suffice for a photo that sees the mesh.
bool sees(const PhotoInput& photo, const std::vector<Eigen::Vector3d>& positions) {
    const Intrinsics& k = photo.camera.intrinsics;
    const double enough = least_share_of_frame * k.width * k.height;
    Eigen::AlignedBox2d box;
    const std::size_t step = std::max<std::size_t>(1, positions.size() / max_examined);
    constexpr std::size_t rounds = 61;
    for (std::size_t first = 0; first < rounds; ++first)
        for (std::size_t v = first * step; v < positions.size(); v += rounds * step) {
            const auto p = project(k, photo.camera.cam_from_world, positions[v]);
            if (!p || p->pixel.x() < 0 || p->pixel.y() < 0 || p->pixel.x() >= k.width ||
                p->pixel.y() >= k.height)
                continue;
            box.extend(p->pixel);
            if (box.volume() >= enough) return true;
        }
    return false;
}

std::string text(const Eigen::AlignedBox3d& box) {
    const auto corner = [](const Eigen::Vector3d& p) {
        return fmt::format("({:.7g}, {:.7g}, {:.7g})", p.x(), p.y(), p.z());
    };
    return "from " + corner(box.min()) + " to " + corner(box.max());
}

}  // namespace

std::vector<std::string> photos_not_seeing_mesh(const SceneInput& scene) {
    std::vector<std::string> names;
    for (const PhotoInput& photo : scene.photos)
        if (!sees(photo, scene.mesh.positions)) names.push_back(photo.name);
    return names;
}

void expect_mesh_in_view(const SceneInput& scene, std::size_t blind) {
    if (2 * blind <= scene.photos.size()) return;
    const MainBox box = main_box(scene.mesh);
    const Eigen::AlignedBox3d mesh(box.low, box.high);
    Eigen::AlignedBox3d cameras;
    for (const PhotoInput& photo : scene.photos) cameras.extend(photo.camera.cam_from_world.center());
    throw Error(
        Exit::misplaced,
        fmt::format("{}: in {} of {} photos it spans less than {} % of the frame, so it is not where the "
                    "cameras look: {} {}, cameras {}",
                    (scene.files.mesh.empty() ? scene.files.points.front() : scene.files.mesh).string(),
                    blind, scene.photos.size(), 100 * least_share_of_frame,
                    scene.files.mesh.empty() ? "points" : "mesh", text(mesh), text(cameras)));
}

}  // namespace vantage
