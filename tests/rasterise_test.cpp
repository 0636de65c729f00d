// The processor renders what a graphics card would.
#include "pipeline/stages/rasterise.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "gl/context.h"
#include "pipeline/import/discover.h"
#include "pipeline/import/read_scene.h"
#include "pipeline/package_layout.h"
#include "pipeline/synth/synthesise.h"
#include "temporary_folder.h"

using namespace vantage;

namespace {

class Rasterise : public TemporaryFolder {};

/// A square of two triangles in the plane z = `z`, turned about the x axis.
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
        return rasterise_geometry({positions, normals}, indices, k, Pose{}, depth_range(positions, Pose{}));
    }
};

const Intrinsics camera{200, 160, 150, 150, 97.3, 81.6};

}  // namespace

TEST_F(Rasterise, APlaneHasItsDepthAndAngleEverywhere) {
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

TEST_F(Rasterise, APlaneThatReachesBehindTheCameraIsCutOff) {
    Square floor(50, 0, 0);
    for (Eigen::Vector3f& p : floor.positions)
        p = {p.x(), 1, p.y()};  // one below the camera, before and behind it
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

TEST_F(Rasterise, NothingShowsBetweenTriangles) {
    // A fan of slivers around the picture's middle: every pixel inside is covered.
    std::vector<Eigen::Vector3f> positions{{0, 0, 5}};
    std::vector<std::uint32_t> indices;
    constexpr std::uint32_t parts = 997;
    for (std::uint32_t i = 0; i < parts; ++i) {
        const float turn = 6.2831853f * float(i) / parts;
        positions.push_back({9 * std::cos(turn), 9 * std::sin(turn), 5});
        for (const std::uint32_t v : {0u, 1 + i, 1 + (i + 1) % parts}) indices.push_back(v);
    }
    const std::vector<Eigen::Vector3f> normals(positions.size(), {0, 0, -1});
    const PhotoGeometry g =
        rasterise_geometry({positions, normals}, indices, camera, Pose{}, depth_range(positions, Pose{}));
    for (const float z : g.z) ASSERT_NEAR(z, 5, 1e-4);
}

TEST_F(Rasterise, AgreesWithOpenGl) {
    SynthSpec spec = read_spec(VANTAGE_SOURCE_DIR "/data/small.toml");
    spec.photos.count = 3;
    spec.photos.samples = 1;
    synthesise(spec, dir / "scene", {});
    SceneInput scene = read_scene(discover(dir / "scene"));
    const PackedModel model = pack_model(scene.mesh, 256);
    const gl::HeadlessContext context;
    const ModelBuffers buffers = upload_model(model.positions, scene.mesh.normals);
    for (const PhotoInput& photo : scene.photos) {
        const Pose pose = photo.camera.cam_from_world.relative_to(model.origin);
        const Intrinsics& k = photo.camera.intrinsics;
        const auto range = depth_range(model.positions, pose);
        const PhotoGeometry a = render_geometry(buffers, model.indices, k, pose, range),
                            b = rasterise_geometry({model.positions, scene.mesh.normals}, model.indices, k,
                                                   pose, range);
        std::size_t depths = 0, angles = 0, visible = 0;
        for (std::size_t i = 0; i < a.z.size(); ++i) {
            depths += !(a.z[i] == b.z[i] || std::abs(a.z[i] - b.z[i]) < 1e-3f * a.z[i]);
            angles += std::abs(int(a.angle[i]) - int(b.angle[i])) > 1;
        }
        double farthest = 0;
        for (std::size_t v = 0; v < a.coordinates.size(); ++v)
            if ((a.coordinates[v].x() >= 0) != (b.coordinates[v].x() >= 0))
                ++visible;
            else if (a.coordinates[v].x() >= 0)
                farthest = std::max(farthest, double((a.coordinates[v] - b.coordinates[v]).norm()) * k.width);
        EXPECT_LT(double(depths) / double(a.z.size()), 2e-3)
            << "texels along contours, an edge's width apart";
        EXPECT_LT(double(angles) / double(a.z.size()), 2e-3);
        EXPECT_LT(double(visible) / double(a.coordinates.size()), 2e-3)
            << "of those that no ray has settled yet";
        EXPECT_LT(farthest, 0.01) << "px";
    }
}
