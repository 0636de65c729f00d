#include "pipeline/visibility/rasterize.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/values/simd.h"
#include "pipeline/visibility/triangle_map.h"

namespace vantage {
namespace {

/// Cosine of the angle between each vertex's normal and the direction to the camera, in [-1, 1].
VANTAGE_SIMD void vertex_cosines(const float* positions, const float* normals, const float* eye,
                                 std::size_t count, float* out) {
    for (std::size_t v = 0; v < count; ++v) {
        const float x = eye[0] - positions[3 * v], y = eye[1] - positions[3 * v + 1],
                    z = eye[2] - positions[3 * v + 2];
        const float length = std::sqrt(x * x + y * y + z * z);
        const float along = x * normals[3 * v] + y * normals[3 * v + 1] + z * normals[3 * v + 2];
        out[v] = along / (length > 0 ? length : 1);
    }
}

/// The cosine at the intersection of a camera ray with a triangle, using the interpolated normal. `corners`
/// are relative to the camera.
float cosine(std::array<Eigen::Vector3f, 3> corners, const std::array<Eigen::Vector3f, 3>& normals,
             const Eigen::Vector3f& ray) {
    // The corners are scaled so that products neither underflow nor overflow.
    const float unit = std::max(corners[0].cwiseAbs().maxCoeff(), corners[1].cwiseAbs().maxCoeff());
    for (Eigen::Vector3f& c : corners) c /= unit;
    // A corner's barycentric weight is the volume spanned by the ray and the opposite edge.
    Eigen::Vector3f n = Eigen::Vector3f::Zero();
    float volume = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const float weight = ray.dot(corners[(i + 1) % 3].cross(corners[(i + 2) % 3]));
        n += weight * normals[i];
        volume += weight;
    }
    const float lengths = n.norm() * ray.norm();
    return lengths > 0 ? (volume < 0 ? n.dot(ray) : -n.dot(ray)) / lengths : 0;
}

VANTAGE_SIMD void to_bytes(const float* value, const float* inverse_depth, std::size_t count,
                           std::uint8_t* out) {
    for (std::size_t i = 0; i < count; ++i) {
        const float cosine = value[i] / (inverse_depth[i] > 0 ? inverse_depth[i] : 1);
        out[i] = std::uint8_t(int(std::min(1.0f, std::max(0.0f, cosine)) * 255 + 0.5f));
    }
}

/// The angle weight [C]. Large triangles, across which the direction to the camera varies, are shaded per
/// pixel; for small ones the cosines are interpolated from the vertices.
std::vector<std::uint8_t> shade(TriangleMap& map, const PhotoProjection& p,
                                std::span<const Eigen::Vector3f> normals,
                                std::span<const std::uint32_t> indices) {
    const Eigen::Vector3f eye = p.cam_from_origin.center().cast<float>();
    const Eigen::Matrix3d world = p.cam_from_origin.R.transpose();
    const Intrinsics& k = p.intrinsics;
    for (std::size_t at = 0; at < map.value.size(); ++at) {
        if (!std::isnan(map.value[at])) continue;
        const auto x = int(at % std::size_t(map.width)), y = int(at / std::size_t(map.width));
        const Eigen::Vector3d ray((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
        const std::uint32_t* v = &indices[3 * std::size_t(map.triangles[at])];
        map.value[at] = map.inverse_depth[at] *
                        cosine({p.positions[v[0]] - eye, p.positions[v[1]] - eye, p.positions[v[2]] - eye},
                               {normals[v[0]], normals[v[1]], normals[v[2]]}, (world * ray).cast<float>());
    }
    std::vector<std::uint8_t> angle(map.value.size());
    to_bytes(map.value.data(), map.inverse_depth.data(), angle.size(), angle.data());
    return angle;
}

/// Unseen pixels, whose inverse depth is 0, become +inf.
std::vector<float> depths(std::vector<float> inverse) {
    for (float& v : inverse) v = 1 / v;
    return inverse;
}

}  // namespace

PhotoGeometry rasterize_geometry(const PhotoProjection& p, std::span<const Eigen::Vector3f> normals,
                                 std::span<const std::uint32_t> indices) {
    const Eigen::Vector3f eye = p.cam_from_origin.center().cast<float>();
    std::vector<float> cosines(normals.size());
    vertex_cosines(p.positions.data()->data(), normals.data()->data(), eye.data(), normals.size(),
                   cosines.data());
    TriangleMap map = rasterize(p, indices, cosines);
    PhotoGeometry out{map.width, map.height, {}, {}, {}};
    out.angle = shade(map, p, normals, indices);
    out.z = depths(std::move(map.inverse_depth));
    out.triangles = std::move(map.triangles);
    return out;
}

}  // namespace vantage
