#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/synth/building.h"
#include "pipeline/synth/synthesize.h"

using namespace vantage;
namespace fs = std::filesystem;

TEST(Synth, WindingAgreesWithNormals) {
    SynthSpec spec;
    spec.object.triangles = 2000;
    const SynthModel model = build_model(spec);
    ASSERT_EQ(model.materials.size(), model.mesh.triangles.size());
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        const auto& v = model.mesh.triangles[t];
        const auto& p = model.mesh.positions;
        const Eigen::Vector3d n = (p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[0]]);
        ASSERT_GT(n.norm(), 0) << t;
        ASSERT_GT(n.dot(model.mesh.normals[v[0]].cast<double>()), 0)
            << t << " of material " << int(model.materials[t]);
    }
}

TEST(Synth, CamerasLookAtTheBuildingFromTheFront) {
    const SynthSpec spec;
    const SynthModel model = build_model(spec);
    const RayScene rays(model.mesh);
    for (const NamedCamera& photo : place_cameras(spec)) {
        const Pose& pose = photo.camera.cam_from_world;
        EXPECT_NEAR(pose.R.determinant(), 1, 1e-12);
        EXPECT_GT(-pose.R(1, 2), 0.9) << "the top of the photo points up";
        const auto hit = rays.first_hit(pose.center(), pose.direction());
        ASSERT_TRUE(hit);
        const auto& v = model.mesh.triangles[hit->triangle];
        EXPECT_LT(pose.direction().dot(model.mesh.normals[v[0]].cast<double>()), 0) << "sees a front face";
    }
}

TEST(Synth, RaysMatchAClosedForm) {
    Mesh square;
    square.positions = {{-1, -1, 3}, {1, -1, 3}, {1, 1, 3}, {-1, 1, 3}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    const RayScene rays(square);
    const Eigen::Vector3d eye(0.2, 0.1, 0), direction(0.1, -0.05, 1);
    const auto hit = rays.first_hit(eye, direction);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 3, 1e-6);
    EXPECT_FALSE(rays.first_hit(eye, {1, 0, 1}));
    EXPECT_TRUE(rays.occluded(eye, direction, 0, 4));
    EXPECT_FALSE(rays.occluded(eye, direction, 0, 2.99));
}

TEST(Synth, SpecErrorsNameTheKey) {
    const fs::path file =
        fs::temp_directory_path() / ("vantage-spec-" + std::to_string(::getpid()) + ".toml");
    const auto message = [&](const char* text) -> std::string {
        std::ofstream(file) << text;
        try {
            read_spec(file);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_NE(message("[photos]\ncuont = 3\n").find("photos.cuont"), std::string::npos);
    EXPECT_NE(message("[photos]\ncount = 0\n").find("photos.count"), std::string::npos);
    EXPECT_NE(message("[photos]\ncount = 2.5\n").find("photos.count"), std::string::npos);
    EXPECT_NE(message("[photo]\ncount = 2\n").find("photo"), std::string::npos);
    EXPECT_NE(message("[photos\n").find(":1"), std::string::npos);
    EXPECT_EQ(message("[photos]\ncount = 2\n"), "");
    fs::remove(file);
}
