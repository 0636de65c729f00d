#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "base/gl/context.h"
#include "pipeline/mesh/clusters.h"
#include "pipeline/stages/coordinates/vertex_coordinates.h"
#include "pipeline/visibility/frame_triangles.h"
#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/rasterize.h"
#include "tests/hard_cases/special_numbers.h"
#include "tests/temporary_folder.h"

namespace vantage {

class Depth : public TemporaryFolder {
  protected:
    static inline const Intrinsics depth_camera{150, 110, 120, 125, 71.3, 57.6};

    /// Unconnected triangles.
    struct Soup {
        std::vector<Eigen::Vector3f> positions;
        std::vector<std::uint32_t> indices;

        void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
            for (const Eigen::Vector3d& p : {a, b, c}) {
                indices.push_back(std::uint32_t(positions.size()));
                positions.push_back(p.cast<float>());
            }
        }
        void add_square(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
            add(corner, corner + u, corner + u + v);
            add(corner, corner + u + v, corner + v);
        }
    };

    /// Distance to a two-sided triangle along `ray`, in units of the length of `ray`; `infinite` if the ray
    /// misses the triangle.
    static double met_at(const Eigen::Vector3d& from, const Eigen::Vector3d& ray,
                         const std::array<Eigen::Vector3d, 3>& p) {
        const Eigen::Vector3d a = p[0] - from, b = p[1] - from, c = p[2] - from;
        const double u = ray.dot(b.cross(c)), v = ray.dot(c.cross(a)), w = ray.dot(a.cross(b));
        if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0)
            return infinite;
        const double t = a.dot((p[1] - p[0]).cross(p[2] - p[0])) / (u + v + w);
        return t > 0 ? t : infinite;
    }

    /// Brute-force ray casting against triangles, in the order of `indices`.
    class Rays {
      public:
        Rays(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices) {
            for (std::size_t t = 0; t < indices.size(); t += 3)
                triangles_.push_back({positions[indices[t]].cast<double>(),
                                      positions[indices[t + 1]].cast<double>(),
                                      positions[indices[t + 2]].cast<double>()});
        }
        double first(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) const {
            double nearest = infinite;
            for (const auto& t : triangles_) nearest = std::min(nearest, met_at(from, ray, t));
            return nearest;
        }
        double at(std::size_t triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) const {
            return met_at(from, ray, triangles_[triangle]);
        }

      private:
        std::vector<std::array<Eigen::Vector3d, 3>> triangles_;
    };

    /// The ray through a pixel in world coordinates, scaled to unit depth.
    static Eigen::Vector3d ray_of(const Intrinsics& k, const Pose& pose, double u, double v) {
        return pose.R.transpose() * Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1);
    }

    class Random {
      public:
        explicit Random(unsigned seed) : engine_(seed) {}
        double operator()(double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(engine_);
        }
        Eigen::Vector3d vector() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
        Eigen::Matrix3d rotation() {
            return Eigen::AngleAxisd((*this)(0, 3), vector().normalized()).toRotationMatrix();
        }

      private:
        std::mt19937 engine_;
    };

    const gl::HeadlessContext context{gl::Debug::on};

    struct Seen {
        const char* by;
        PhotoGeometry geometry;
    };
    /// The results of both rasterizers (processor and OpenGL) for the clusters that intersect the frame.
    static std::vector<Seen> seen(Soup soup, const Intrinsics& k, const Pose& pose) {
        const auto clusters = make_clusters(soup.positions, soup.indices, 64);
        const FrameTriangles in_frame = triangles_in_frame(clusters, soup.indices, k, pose);
        const Eigen::Vector2d range = depth_range(soup.positions, pose);
        const std::vector<Eigen::Vector3f> normals(soup.positions.size(), {0, 0, -1});
        const PhotoProjection p = project_model(soup.positions, map_intrinsics(k), pose, range.x());
        return {{"processor", rasterize_geometry(p, normals, in_frame.indices)},
                {"OpenGL",
                 render_geometry(upload_model(soup.positions, normals), in_frame.indices, k, pose, range)}};
    }
    static std::vector<Eigen::Vector2f> coordinates(const Soup& soup, const Intrinsics& k, const Pose& pose) {
        return vertex_coordinates(
            project_model(soup.positions, map_intrinsics(k), pose, depth_range(soup.positions, pose).x()),
            soup.indices, k);
    }

    /// Counts the depths outside the range of depths that rays find within `reach` pixels of the map.
    static std::size_t count_wrong(const PhotoGeometry& g, const Soup& soup, const Intrinsics& k,
                                   const Pose& pose, double reach) {
        const Rays rays(soup.positions, soup.indices);
        const Intrinsics map = map_intrinsics(k);
        const Eigen::Vector3d eye = pose.center();
        std::size_t wrong = 0;
        for (int y = 0; y < g.height; ++y)
            for (int x = 0; x < g.width; ++x) {
                double least = infinite, most = 0;
                for (const auto& [dx, dy] : {std::pair(0, 0),
                                             {-1, -1},
                                             {1, -1},
                                             {-1, 1},
                                             {1, 1},
                                             {0, 1},
                                             {0, -1},
                                             {1, 0},
                                             {-1, 0}}) {
                    const double z =
                        rays.first(eye, ray_of(map, pose, x + 0.5 + dx * reach, y + 0.5 + dy * reach));
                    least = std::min(least, z);
                    most = std::max(most, z);
                }
                const double z = double(g.z[std::size_t(y) * std::size_t(g.width) + std::size_t(x)]);
                wrong += !(z > 0) || !(z >= least * (1 - 1e-4) && z <= most * (1 + 1e-4));
            }
        return wrong;
    }
};

}  // namespace vantage
