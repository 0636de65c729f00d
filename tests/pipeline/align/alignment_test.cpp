// Aligns the mesh of a real scan after random transformations, and refuses a mesh that is unrelated to the
// photos.
#include "pipeline/align/alignment.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "tests/datasets.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

/// The median displacement of vertices in the photos, in px, computed with an independent projection.
double median_off(const SceneInput& right, const SceneInput& moved, const Similarity& mesh_from_cameras) {
    std::vector<double> off;
    const Similarity& s = mesh_from_cameras;
    for (const PhotoInput& p : right.photos)
        for (std::size_t v = 0; v < right.mesh.positions.size(); v += 97) {
            const Pose& pose = p.camera.cam_from_world;
            const Vector3d back = s.R.transpose() * (moved.mesh.positions[v] - s.t) / s.scale;
            const auto here = project(p.camera.intrinsics, pose, right.mesh.positions[v]),
                       there = project(p.camera.intrinsics, pose, back);
            if (here && in_frame(p.camera.intrinsics, here->pixel))
                off.push_back(there ? (here->pixel - there->pixel).norm() : 1e9);
        }
    std::ranges::nth_element(off, off.begin() + std::ptrdiff_t(off.size() / 2));
    return off[off.size() / 2];
}

void expect_found(int placements, unsigned seed) {
    VANTAGE_DATASET(scan, "sceaux-small");
    const SceneInput right = read_scene(discover(scan));
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < placements; ++i) {
        const Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
        const double scale = std::exp(2 * normal(random));
        SceneInput moved = right;
        for (Vector3d& p : moved.mesh.positions)
            p = scale * (turn.normalized() * p) + Vector3d(100, -2000, 30);
        const Alignment a = align(moved);
        const double off = median_off(right, moved, a.mesh_from_cameras);
        EXPECT_LT(off, 3 * a.pixels) << i;
        EXPECT_LT(off, 1) << i;
        ::testing::Test::RecordProperty("off_" + std::to_string(i), std::to_string(off));
        ::testing::Test::RecordProperty("standard_error_" + std::to_string(i), std::to_string(a.pixels));
    }
}

}  // namespace

TEST(Align, FindsAMeshThatWasTurnedMovedAndScaled) { expect_found(1, 8); }

TEST(AlignAtLength, FindsAMeshThatWasTurnedMovedAndScaled) { expect_found(2, 9); }

TEST(AlignAtLength, RefusesAMeshThatIsNotOfThePhotos) {
    VANTAGE_DATASET(scan, "sceaux-small");
    VANTAGE_DATASET(other, "fountain-P11");
    SceneInput scene = read_scene(discover(scan));
    scene.mesh = read_scene(discover(other)).mesh;
    try {
        align(scene);
        ADD_FAILURE() << "aligned";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::misplaced) << e.what();
        EXPECT_NE(std::string(e.what()).find("cannot be aligned"), std::string::npos) << e.what();
    }
}

}  // namespace vantage
