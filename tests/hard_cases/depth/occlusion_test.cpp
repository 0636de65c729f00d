// Tests surfaces that are so close to each other that they only just occlude each other or only just do not.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "pipeline/stages/coordinates/vertex_coordinates.h"
#include "pipeline/visibility/photo_geometry.h"
#include "tests/hard_cases/depth/triangle_soup.h"

using namespace vantage;

TEST_F(Depth, NoTriangleOccludesItsOwnVertices) {
    Random random(8);
    Intrinsics tele = depth_camera;  // a pixel's footprint is smaller than a float's last digit
    tele.fx = tele.fy = 1e8;
    for (int trial = 0; trial < 20000; ++trial) {
        const Intrinsics& k = trial % 2 ? tele : depth_camera;
        // Slivers with the smallest areas that are still rasterized, with corners at different depths.
        const double reach = trial % 4 < 2 ? 100 : 3;
        const Eigen::Vector2d a(random(5, 145), random(5, 105)),
            b = a + reach * Eigen::Vector2d(random(-1, 1), random(-1, 1));
        const Eigen::Vector2d across = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
        const Eigen::Vector2d c = a + random(0, 1) * (b - a) + std::pow(10, random(-4.5, -1)) * across;
        const auto at_depth = [&](const Eigen::Vector2d& p) -> Eigen::Vector3d {
            return std::pow(10, random(0, 2)) * ray_of(k, Pose{}, p.x(), p.y());
        };
        Soup soup;
        soup.add(at_depth(a), at_depth(b), at_depth(c));
        const auto found = coordinates(soup, k, Pose{});
        for (std::size_t v = 0; v < 3; ++v) {
            const auto at = project(k, Pose{}, soup.positions[v].cast<double>());
            ASSERT_EQ(found[v].x() >= 0, at && in_frame(k, at->pixel)) << "trial " << trial;
        }
    }
}

TEST_F(Depth, GeometryBehindTheCameraIsNotSeen) {
    Soup soup;
    soup.add_square({-2, -2, -3}, {4, 0, 0}, {0, 4, 0});
    soup.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});     // touching the camera's center, in its plane
    soup.add({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});  // in its plane, around the camera
    soup.add({0, 0, 0}, {1, 0, -1}, {0, 1, -1});   // from its center backwards
    EXPECT_EQ(depth_range(soup.positions, Pose{}), Eigen::Vector2d(0, 0));
    for (const Seen& s : seen(soup, depth_camera, Pose{}))
        for (const float z : s.geometry.z) ASSERT_TRUE(std::isinf(z) && z > 0) << s.by;
    for (const auto& uv : coordinates(soup, depth_camera, Pose{})) EXPECT_EQ(uv, Eigen::Vector2f(-1, -1));
    const PhotoProjection nothing = project_model(soup.positions, map_intrinsics(depth_camera), Pose{}, 0);
    for (std::size_t i = 0; i < soup.indices.size(); i += 3)
        EXPECT_EQ(clipped(nothing, &soup.indices[i]).count, 0)
            << "nothing should remain of infinitely near pieces";
}

TEST_F(Depth, SurfacesOccludeEachOtherBeyondAThirdOfAPixel) {
    // Distances along the line of sight are in pixel footprints; occlusion begins at a third of a footprint.
    const Intrinsics k{400, 300, 380, 380, 201.7, 148.2};
    for (const double tilt : {0.0, 0.6, -1.1})
        for (const double apart : {1.0, 0.5, 0.2, 0.0}) {
            Soup soup;
            const Eigen::Matrix3d R = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()).toRotationMatrix();
            const auto point = [&](int i, int j) -> Eigen::Vector3d {
                return R * Eigen::Vector3d(0.25 * i, 0.25 * j, 0) + Eigen::Vector3d(0.011, 0.017, 20);
            };
            const double shares[] = {1, 1 + apart / k.fx};
            for (const double share : shares)
                for (int j = -16; j < 16; ++j)
                    for (int i = -24; i < 24; ++i) {
                        // The far corners are behind the interiors of near triangles.
                        const auto at = [&](int di, int dj) -> Eigen::Vector3d {
                            const Eigen::Vector3d p = point(i + di, j + dj);
                            return share * (share > 1 ? p + R * Eigen::Vector3d(0.08, 0.11, 0) : p);
                        };
                        soup.add(at(0, 0), at(1, 0), at(1, 1));
                        soup.add(at(0, 0), at(1, 1), at(0, 1));
                    }
            const auto found = coordinates(soup, k, Pose{});
            std::size_t near_hidden = 0, far_seen = 0, far = 0;
            for (std::size_t v = 0; v < found.size(); ++v) {
                const Eigen::Vector3d p = soup.positions[v].cast<double>();
                const Eigen::Vector3d on_plane = R.transpose() * (p - point(0, 0));
                if (v < found.size() / 2) {
                    near_hidden += found[v].x() < 0;
                } else if (std::abs(on_plane.x()) < 5.5 &&
                           std::abs(on_plane.y()) < 3.5) {  // entirely behind the near one
                    ++far;
                    far_seen += found[v].x() >= 0;
                }
            }
            EXPECT_EQ(near_hidden, 0u) << "apart " << apart << " tilt " << tilt;
            EXPECT_EQ(far_seen, apart > 1 / 3.0 ? 0 : far) << "apart " << apart << " tilt " << tilt;
            for (const Seen& s : seen(soup, k, Pose{})) {
                if (apart < 1) continue;
                for (int y = 20; y < s.geometry.height - 20; ++y)
                    for (int x = 60; x < s.geometry.width - 60; ++x) {
                        const Eigen::Vector3d ray = ray_of(map_intrinsics(k), Pose{}, x + 0.5, y + 0.5);
                        const Eigen::Vector3d n = R.col(2);
                        const double z = n.dot(point(0, 0)) / n.dot(ray);
                        const Eigen::Vector3d on_plane = R.transpose() * (z * ray - point(0, 0));
                        if (std::abs(on_plane.x()) > 5.5 || std::abs(on_plane.y()) > 3.5) continue;
                        ASSERT_LT(s.geometry.z[std::size_t(y * s.geometry.width + x)], z * (1 + 0.5 / k.fx))
                            << s.by << " tilt " << tilt << " at " << x << "," << y;
                    }
            }
        }
}

TEST_F(Depth, FinelyTessellatedSphereDoesNotOccludeItsNearSide) {
    // The facets lie inside the sphere, so they occlude no line of sight to its near side. The cap up to the
    // horizon is visible, and so is a narrow zone beyond it, where facets are below the horizon.
    constexpr std::uint32_t rings = 500, sectors = 1000;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const std::uint32_t a = r * sectors + s, b = r * sectors + (s + 1) % sectors;
            for (const std::uint32_t v : {a, b, a + sectors, b, b + sectors, a + sectors})
                indices.push_back(v);
        }
    struct Sight {
        double distance, focal;
    };
    // The whole sphere, a part of it from close up, and its center through long lenses.
    for (const auto& [distance, focal] : {Sight{3, 700}, {1.06, 60}, {40, 15000}, {500, 3e5}}) {
        const Eigen::Vector3d center(0.1, -0.06, distance);
        std::vector<Eigen::Vector3f> positions;
        for (std::uint32_t r = 0; r <= rings; ++r)
            for (std::uint32_t s = 0; s < sectors; ++s) {
                const double polar = M_PI * r / rings, turn = 2 * M_PI * s / sectors;
                const Eigen::Vector3d n(std::sin(polar) * std::cos(turn), std::cos(polar),
                                        std::sin(polar) * std::sin(turn));
                positions.push_back((center + n).cast<float>());
            }
        const Intrinsics k{800, 600, focal, focal, 400, 300};
        const Pose pose;
        const auto found = vertex_coordinates(
            project_model(positions, map_intrinsics(k), pose, depth_range(positions, pose).x()), indices, k);
        std::size_t in_cap = 0, hidden = 0, beyond = 0, shown = 0;
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const Eigen::Vector3d p = positions[v].cast<double>();
            const auto at = project(k, pose, p);
            if (!at || !in_frame(k, at->pixel)) continue;
            // Positive if the point is in front of the plane in which the tangent cone touches the sphere.
            const double before = -(p - center).dot(p);
            if (before > 1e-6 * distance) ++in_cap, hidden += found[v].x() < 0;
            if (before < -0.03 * p.norm()) ++beyond, shown += found[v].x() >= 0;
        }
        EXPECT_GT(in_cap, 8000u) << distance;
        EXPECT_LT(double(hidden), 1e-4 * double(in_cap)) << "at " << distance << ": of " << in_cap;
        EXPECT_EQ(shown, 0u) << "at " << distance << ": of " << beyond;
    }
}
