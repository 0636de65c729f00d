#include "tests/bench/scenes/model.h"

#include <algorithm>

#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/photo_geometry.h"

namespace vantage::bench {

BenchModel::BenchModel(SceneInput scene) : scene_(std::move(scene)) {
    const Eigen::Vector3d origin = scene_.mesh.positions.front();
    for (const Eigen::Vector3d& p : scene_.mesh.positions) positions_.push_back((p - origin).cast<float>());
    for (const auto& t : scene_.mesh.triangles) indices_.insert(indices_.end(), t.begin(), t.end());
    for (PhotoInput& photo : scene_.photos)
        photo.camera.cam_from_world = photo.camera.cam_from_world.relative_to(origin);
    buffers_ = upload_model(positions_, scene_.mesh.normals);
}

std::vector<Camera> BenchModel::some_cameras(std::size_t count) const {
    const std::size_t all = scene_.photos.size(), some = std::min(count, all);
    std::vector<Camera> out;
    for (std::size_t i = 0; i < some; ++i)
        out.push_back(scene_.photos[(2 * i + 1) * all / (2 * some)].camera);
    return out;
}

PhotoGeometry BenchModel::geometry(const Intrinsics& intrinsics, const Pose& pose) const {
    return render_geometry(buffers_, indices_, intrinsics, pose, depth_range(positions_, pose));
}

}  // namespace vantage::bench
