#include "pipeline/align/convention_table.h"

#include <utility>

namespace vantage {
namespace {

Similarity turn(const Eigen::Matrix3d& R) { return {R, Eigen::Vector3d::Zero(), 1}; }

Eigen::Matrix3d rows(const Eigen::Vector3d& x, const Eigen::Vector3d& y, const Eigen::Vector3d& z) {
    Eigen::Matrix3d m;
    m << x.transpose(), y.transpose(), z.transpose();
    return m;
}

using Eigen::Vector3d;
const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();

/// The camera in a frame that is rotated relative to the file's.
std::optional<Camera> turned(Camera camera, const Eigen::Matrix3d& R) {
    camera.cam_from_world = compose(camera.cam_from_world, turn(R.transpose()));
    return camera;
}

/// The index of the first of two consecutive tangential coefficients; empty without tangential terms.
std::optional<std::size_t> tangential(LensModel model) {
    switch (model) {
        case LensModel::opencv:
        case LensModel::brown:
        case LensModel::thin_prism:
            return 2;
        case LensModel::aria:
            return 6;
        default:
            return {};
    }
}

std::optional<Camera> looking_backward(Camera camera, const Similarity&) {
    const Eigen::DiagonalMatrix<double, 3> flip(1, -1, -1);
    camera.cam_from_world.R = flip * camera.cam_from_world.R;
    camera.cam_from_world.t = flip * camera.cam_from_world.t;
    return camera;
}

std::optional<Camera> transposed(Camera camera, const Similarity&) {
    const Vector3d center = camera.cam_from_world.center();
    camera.cam_from_world.R.transposeInPlace();
    camera.cam_from_world.t = -camera.cam_from_world.R * center;
    return camera;
}

constexpr Convention table[] = {
    {"camera-y-up", "the cameras look along -z, with y up", false, looking_backward},
    {"transposed", "the rotations are inverted", false, transposed},
    {"swapped-tangential", "the lens's two tangential coefficients are swapped", false, swapped_tangential},
    {"no-transform", "the mesh is in the frame before the camera file's own transform", true,
     without_transform},
    {"mesh-turned", "the mesh is turned by 180 degrees about x: (x, -y, -z)", true,
     [](Camera c, const Similarity&) { return turned(c, rows(x, -y, -z)); }},
    {"mesh-y-up", "the mesh has y up where the cameras have z: (x, z, -y)", true,
     [](Camera c, const Similarity&) { return turned(c, rows(x, z, -y)); }},
    {"mesh-z-up", "the mesh has z up where the cameras have y: (x, -z, y)", true,
     [](Camera c, const Similarity&) { return turned(c, rows(x, -z, y)); }},
    {"mesh-xy-swapped", "the mesh has the axes of nerfstudio: (y, x, -z)", true,
     [](Camera c, const Similarity&) { return turned(c, rows(y, x, -z)); }}};

}  // namespace

std::span<const Convention> convention_table() { return table; }

std::optional<Camera> without_transform(Camera camera, const Similarity& transform) {
    if (transform.R.isIdentity() && transform.t.isZero() && transform.scale == 1) return {};
    camera.cam_from_world = compose(camera.cam_from_world, transform);
    return camera;
}

std::optional<Camera> swapped_tangential(Camera camera, const Similarity&) {
    const auto first = tangential(camera.lens.model);
    if (!first || camera.lens.p[*first] == camera.lens.p[*first + 1]) return {};
    std::swap(camera.lens.p[*first], camera.lens.p[*first + 1]);
    return camera;
}

}  // namespace vantage
