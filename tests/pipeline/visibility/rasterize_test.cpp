// Compares the software rasterizer with closed forms, OpenGL and ray casting.
#include "pipeline/visibility/rasterize.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "base/gl/context.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/packed_model.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/output/chunk_plan.h"
#include "pipeline/stages/coordinates/vertex_coordinates.h"
#include "pipeline/synth/synthesize.h"
#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/photo_geometry.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class Rasterize : public TemporaryFolder {};

PhotoProjection projected(std::span<const Eigen::Vector3f> positions, const Intrinsics& photo,
                          const Pose& pose) {
    return project_model(positions, map_intrinsics(photo), pose, depth_range(positions, pose).x());
}

/// A square made of two triangles. Its center is at depth `z`, and it is rotated about the x axis by `turn`.
struct Square {
    std::vector<Eigen::Vector3f> positions, normals;
    std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
    Square(float half, float z, float turn) {
        const Eigen::Matrix3f R = Eigen::AngleAxisf(turn, Eigen::Vector3f::UnitX()).toRotationMatrix();
        for (const auto& [x, y] : {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}}) {
            positions.push_back(R * Eigen::Vector3f(x, y, 0) + Eigen::Vector3f(0, 0, z));
            normals.push_back(R * -Eigen::Vector3f::UnitZ());
        }
    }
    PhotoGeometry seen(const Intrinsics& k) const {
        return rasterize_geometry(projected(positions, k, Pose{}), normals, indices);
    }
};

const Intrinsics camera{200, 160, 150, 150, 97.3, 81.6};

}  // namespace

TEST_F(Rasterize, PlaneMatchesItsClosedForm) {
    for (const float turn : {0.0f, 0.7f, -1.2f}) {
        const Square square(40, 6, turn);
        const PhotoGeometry g = square.seen(camera);
        const Eigen::Vector3d n = square.normals[0].cast<double>();
        const double distance = n.dot(square.positions[0].cast<double>());
        for (int y = 0; y < g.height; ++y)
            for (int x = 0; x < g.width; ++x) {
                const Eigen::Vector3d ray((2 * (x + 0.5) - camera.cx) / camera.fx,
                                          (2 * (y + 0.5) - camera.cy) / camera.fy, 1);
                const double z = distance / n.dot(ray);
                const std::size_t at = std::size_t(y * g.width + x);
                const Eigen::Vector3d point = z * ray;
                if (!(z > 0.1 && std::abs(point.x()) < 38 && std::abs(point.y()) < 38 * std::cos(turn) - 0.5))
                    continue;
                ASSERT_NEAR(g.z[at], z, 2e-3 * z) << turn << " at " << x << "," << y;
                ASSERT_NEAR(g.angle[at], 255 * -n.dot(ray) / ray.norm(), 1) << turn;
            }
    }
}

TEST_F(Rasterize, PlaneReachingBehindTheCameraIsClipped) {
    Square floor(50, 0, 0);
    for (Eigen::Vector3f& p : floor.positions)
        p = {p.x(), 1, p.y()};  // one unit below the camera, in front of and behind it
    for (Eigen::Vector3f& n : floor.normals) n = {0, -1, 0};
    const PhotoGeometry g = floor.seen(camera);
    std::size_t seen = 0;
    for (int y = 0; y < g.height; ++y)
        for (int x = 0; x < g.width; ++x) {
            const double down = (2 * (y + 0.5) - camera.cy) / camera.fy;
            const float z = g.z[std::size_t(y * g.width + x)];
            if (down > 1.0 / 45) {
                ASSERT_NEAR(z, 1 / down, 1e-3 / down) << x << "," << y;
                ++seen;
            } else if (down < 0) {
                ASSERT_TRUE(std::isinf(z)) << x << "," << y;
            }
        }
    EXPECT_GT(seen, 3000u);
}

TEST_F(Rasterize, AdjacentTrianglesLeaveNoGaps) {
    // A fan of slivers around the center covers the whole frame.
    std::vector<Eigen::Vector3f> positions{{0, 0, 5}};
    std::vector<std::uint32_t> indices;
    constexpr std::uint32_t parts = 997;
    for (std::uint32_t i = 0; i < parts; ++i) {
        const float turn = 6.2831853f * float(i) / parts;
        positions.push_back({9 * std::cos(turn), 9 * std::sin(turn), 5});
        for (const std::uint32_t v : {0u, 1 + i, 1 + (i + 1) % parts}) indices.push_back(v);
    }
    const std::vector<Eigen::Vector3f> normals(positions.size(), {0, 0, -1});
    const PhotoGeometry g = rasterize_geometry(projected(positions, camera, Pose{}), normals, indices);
    for (const float z : g.z) ASSERT_NEAR(z, 5, 1e-4);
}

TEST_F(Rasterize, AgreesWithOpenGl) {
    SynthSpec spec = spec_named("small");
    spec.photos.count = 3;
    spec.photos.samples = 1;
    copy_scene(spec, dir / "scene");
    SceneInput scene = read_scene(discover(dir / "scene"));
    const PackedModel model = pack_model(scene.mesh, main_box(scene.mesh));
    const gl::HeadlessContext context(gl::Debug::on);
    const ModelBuffers buffers = upload_model(model.positions, scene.mesh.normals);
    for (const PhotoInput& photo : scene.photos) {
        const Pose pose = photo.camera.cam_from_world.relative_to(model.origin);
        const Intrinsics& k = photo.camera.intrinsics;
        const auto range = depth_range(model.positions, pose);
        const PhotoGeometry a = render_geometry(buffers, model.indices, k, pose, range),
                            b = rasterize_geometry(projected(model.positions, k, pose), scene.mesh.normals,
                                                   model.indices);
        std::size_t depths = 0, angles = 0;
        for (std::size_t i = 0; i < a.z.size(); ++i) {
            depths += !(a.z[i] == b.z[i] || std::abs(a.z[i] - b.z[i]) < 1e-3f * a.z[i]);
            angles += std::abs(int(a.angle[i]) - int(b.angle[i])) > 1;
        }
        EXPECT_LT(double(depths) / double(a.z.size()), 2e-3) << "differences are allowed only along contours";
        EXPECT_LT(double(angles) / double(a.z.size()), 2e-3);
    }
}

TEST_F(Rasterize, VertexVisibilityMatchesRayCasting) {
    // Triangles of all sizes surround the camera, and some of them cross its plane. They are random, so that
    // hardly any vertex is a borderline case.
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(-1, 1);
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    for (int t = 0; t < 3000; ++t) {
        const float size = std::pow(10.0f, unit(random) - 1) * (t % 50 ? 1.0f : 30.0f);
        const Eigen::Vector3f center(8 * unit(random), 6 * unit(random), 6 + 8 * unit(random));
        for (int c = 0; c < 3; ++c) {
            indices.push_back(std::uint32_t(positions.size()));
            positions.push_back(center + size * Eigen::Vector3f(unit(random), unit(random), unit(random)));
        }
    }
    const RayScene rays(positions, indices);
    // The second frame has several vertices per pixel.
    for (const Intrinsics& k : {camera, Intrinsics{32, 24, 24, 24, 15.3, 12.6}}) {
        const auto found = vertex_coordinates(projected(positions, k, Pose{}), indices, k);
        std::size_t seen = 0, hidden = 0, differ = 0;
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const Eigen::Vector3d point = positions[v].cast<double>();
            const auto at = project(k, Pose{}, point);
            if (!at || !in_frame(k, at->pixel)) {
                EXPECT_EQ(found[v], Eigen::Vector2f(-1, -1));
                continue;
            }
            const bool free = !rays.occluded(Eigen::Vector3d::Zero(), point, 0, 1 - 0.3 / k.fx);
            differ += free != (found[v].x() >= 0);
            ++(free ? seen : hidden);
            if (found[v].x() < 0) continue;
            EXPECT_NEAR(found[v].x() * float(k.width), at->pixel.x(), 1e-3);
            EXPECT_NEAR(found[v].y() * float(k.height), at->pixel.y(), 1e-3);
        }
        EXPECT_GT(seen, 300u) << k.width;
        EXPECT_GT(hidden, 300u) << k.width;
        EXPECT_EQ(differ, 0u) << "of " << seen + hidden << " in " << k.width;
    }
}

TEST_F(Rasterize, VisibilityTakesNoMoreWorkPerTriangleFromFarAway) {
    // Two wavy sheets, one behind the other, upright and diagonal. They fill the frame, or are seen from 5
    // and 20 times the distance, where hundreds of triangles share a pixel.
    constexpr std::uint32_t side = 250;
    for (const double turn : {0.0, 0.7})
        for (const double tilt : {0.0, 1.3})
            for (const float far : {1.0f, 5.0f, 20.0f}) {
                const Eigen::Matrix3f R = (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                                           Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()))
                                              .toRotationMatrix()
                                              .cast<float>();
                std::vector<Eigen::Vector3f> positions;
                std::vector<std::uint32_t> indices;
                for (std::uint32_t sheet = 0; sheet < 2; ++sheet)
                    for (std::uint32_t i = 0; i <= side; ++i)
                        for (std::uint32_t j = 0; j <= side; ++j) {
                            const float x = 2 * float(j) / side - 1, y = 2 * float(i) / side - 1;
                            const float z = 0.1f * std::sin(7 * x) * std::cos(5 * y) + 0.5f * float(sheet);
                            positions.push_back(R * Eigen::Vector3f(x, y, z) +
                                                Eigen::Vector3f(0, 0, 2.6f * far));
                            const std::uint32_t a = std::uint32_t(positions.size()) - 1, b = a + side + 1;
                            if (i < side && j < side)
                                indices.insert(indices.end(), {a, a + 1, b + 1, a, b + 1, b});
                        }
                const Intrinsics k{800, 600, 800, 800, 400, 300};
                std::uint64_t tests = 0;
                const auto found = vertex_coordinates(projected(positions, k, Pose{}), indices, k, &tests);
                const double triangles = double(indices.size()) / 3;
                EXPECT_GT(double(tests), 0.5 * triangles);
                EXPECT_LT(double(tests), 25 * triangles)
                    << "far " << far << ", turned " << turn << ", " << tilt;
                const auto seen = std::ranges::count_if(found, [](const auto& at) { return at.x() >= 0; });
                EXPECT_GT(double(seen), 0.3 * double(found.size()));
            }
}

TEST_F(Rasterize, CurvedSurfaceDoesNotOccludeItself) {
    // A finely tessellated sphere: vertices that face the camera are visible, and the others are not.
    constexpr int rings = 180, sectors = 360;
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    for (int r = 0; r <= rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const double polar = M_PI * r / rings, turn = 2 * M_PI * s / sectors;
            positions.push_back(Eigen::Vector3d(std::sin(polar) * std::cos(turn), std::cos(polar),
                                                5 + std::sin(polar) * std::sin(turn))
                                    .cast<float>());
        }
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const std::uint32_t a = r * sectors + s, b = r * sectors + (s + 1) % sectors;
            for (const std::uint32_t v : {a, b, a + sectors, b, b + sectors, a + sectors})
                indices.push_back(v);
        }
    const Intrinsics k{1600, 1200, 2400, 2400, 800, 600};
    const auto found = vertex_coordinates(projected(positions, k, Pose{}), indices, k);
    std::size_t differ = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Eigen::Vector3f n = positions[v] - Eigen::Vector3f(0, 0, 5);
        const float facing = -n.dot(positions[v].normalized());
        // Near the horizon, the slope of the facets differs from that of the sphere.
        if (std::abs(facing) > 0.02f) differ += (facing > 0) != (found[v].x() >= 0);
    }
    EXPECT_EQ(differ, 0u) << "of " << positions.size();
}
