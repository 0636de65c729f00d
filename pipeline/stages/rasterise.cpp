#include "pipeline/stages/rasterise.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pipeline/stages/triangle_map.h"
#include "pipeline/stages/wide.h"

namespace vantage {
namespace {

/// Interpolated normals of triangles, in the order in which rows of pixels see them: most have been met a row
/// before.
class Normals {
  public:
    Normals(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
            std::span<const std::uint32_t> indices, const Eigen::Vector3f& eye)
        : positions_(positions), normals_(normals), indices_(indices), eye_(eye), met_(4096) {}

    /// From a ray from the camera, the normal where it meets the triangle: of any length, by the side that is
    /// seen; the fourth row is 0. Until the next call.
    const Eigen::Matrix<float, 4, 3>& of(std::uint32_t triangle) {
        Facing& f = met_[triangle % met_.size()];
        if (f.triangle != triangle) f = facing(triangle);
        return f.normal;
    }

  private:
    struct Facing {
        Eigen::Matrix<float, 4, 3> normal;
        std::uint32_t triangle = TriangleMap::none;
    };

    /// The weights of the corners are the volumes that the ray spans with the edges across.
    Facing facing(std::uint32_t triangle) const {
        const std::uint32_t* v = &indices_[3 * std::size_t(triangle)];
        Eigen::Vector3f c[3] = {positions_[v[0]] - eye_, positions_[v[1]] - eye_, positions_[v[2]] - eye_};
        // In units of its distance, so that products neither vanish nor overflow.
        const float unit = 1 / std::max(c[0].cwiseAbs().maxCoeff(), c[1].cwiseAbs().maxCoeff());
        for (Eigen::Vector3f& corner : c) corner *= unit;
        const Eigen::Vector3f across[3] = {c[1].cross(c[2]), c[2].cross(c[0]), c[0].cross(c[1])};
        const float side = c[0].dot(across[0]) < 0 ? -1 : 1;
        Facing f;
        f.normal.setZero();
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3f& n = normals_[v[i]];
            const Eigen::Vector4f turned(side * n.x(), side * n.y(), side * n.z(), 0);
            for (int j = 0; j < 3; ++j) f.normal.col(j) += across[i][j] * turned;
        }
        f.triangle = triangle;
        return f;
    }

    std::span<const Eigen::Vector3f> positions_, normals_;
    std::span<const std::uint32_t> indices_;
    Eigen::Vector3f eye_;
    std::vector<Facing> met_;
};

/// The normals that the pixels of a row see, by their rays; along a triangle they are linear. 0 where nothing
/// is seen.
void normals_of_row(const std::uint32_t* triangles, Normals& normals, const Eigen::Vector4f& first,
                    const Eigen::Vector4f& right, std::vector<Eigen::Vector4f>& row) {
    for (std::size_t x = 0; x < row.size();) {
        const std::uint32_t seen = triangles[x];
        Eigen::Vector4f n = Eigen::Vector4f::Zero(), step = n;
        if (seen != TriangleMap::none) {
            const auto& normal = normals.of(seen);
            const Eigen::Vector4f ray = first + float(x) * right;
            n = normal.col(0) * ray[0] + normal.col(1) * ray[1] + normal.col(2) * ray[2];
            step = normal.col(0) * right[0] + normal.col(1) * right[1] + normal.col(2) * right[2];
        }
        do {
            row[x++] = n;
            n += step;
        } while (x < row.size() && triangles[x] == seen);
    }
}

/// The cosines between normals and the directions to the camera, of rays that are `right` apart (Callieri et
/// al. 2008).
VANTAGE_WIDE void shade_row(const Eigen::Vector4f* normals, const float* first, const float* right, int width,
                            std::uint8_t* angle) {
    const float* n = normals->data();
    for (int x = 0; x < width; ++x) {
        const float a = first[0] + float(x) * right[0], b = first[1] + float(x) * right[1],
                    c = first[2] + float(x) * right[2];
        const float nx = n[4 * x], ny = n[4 * x + 1], nz = n[4 * x + 2];
        const float lengths = std::sqrt((nx * nx + ny * ny + nz * nz) * (a * a + b * b + c * c));
        const float cosine = (nx * a + ny * b + nz * c) / (lengths > 0 ? lengths : 1);
        angle[x] = std::uint8_t(int(std::min(1.0f, std::max(0.0f, -cosine)) * 255 + 0.5f));
    }
}

/// The angle of every pixel from the triangle that it shows.
std::vector<std::uint8_t> shade(const TriangleMap& map, Normals normals, const Intrinsics& k,
                                const Pose& pose) {
    // Rays in the world's axes, in which the normals are.
    const Eigen::Matrix3d world = pose.R.transpose();
    Eigen::Vector4f right = Eigen::Vector4f::Zero(), first = right;
    right.head<3>() = (world.col(0) / k.fx).cast<float>();
    std::vector<std::uint8_t> angle(map.triangles.size());
    std::vector<Eigen::Vector4f> row(std::size_t(map.width));
    std::size_t at = 0;
    for (int y = 0; y < map.height; ++y) {
        first.head<3>() =
            (world * Eigen::Vector3d((0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1)).cast<float>();
        normals_of_row(&map.triangles[at], normals, first, right, row);
        shade_row(row.data(), first.data(), right.data(), map.width, &angle[at]);
        at += std::size_t(map.width);
    }
    return angle;
}

/// 1/0 is infinite: nothing is seen there.
std::vector<float> depths(std::vector<float> inverse) {
    for (float& v : inverse) v = 1 / v;
    return inverse;
}

}  // namespace

PhotoGeometry rasterise_geometry(const PhotoProjection& p, std::span<const Eigen::Vector3f> normals,
                                 std::span<const std::uint32_t> indices) {
    TriangleMap map = rasterise(p, indices);
    PhotoGeometry out{map.width, map.height, {}, {}, {}};
    const Eigen::Vector3f eye = p.cam_from_origin.center().cast<float>();
    out.angle = shade(map, Normals(p.positions, normals, indices, eye), p.intrinsics, p.cam_from_origin);
    out.z = depths(std::move(map.inverse_depth));
    out.triangles = std::move(map.triangles);
    return out;
}

}  // namespace vantage
