#include "tests/bench/scenes/model.h"

#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/photo_geometry.h"
#include "tests/bench/scenes/evenly_spread.h"

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
    std::vector<Camera> all;
    for (const PhotoInput& photo : scene_.photos) all.push_back(photo.camera);
    return evenly_spread(all, count);
}

PhotoGeometry BenchModel::geometry(const Intrinsics& intrinsics, const Pose& pose) const {
    return render_geometry(buffers_, indices_, intrinsics, pose, depth_range(positions_, pose));
}

}  // namespace vantage::bench
