#include "player/survey/picture_plane.h"

#include <gtest/gtest.h>

#include "base/text/error.h"
#include "player/pictures/orthophoto.h"
#include "tests/player/test_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

/// The direction from the plane toward its viewer.
Vector3d viewer(const PicturePlane& p) { return p.right.cross(p.up); }

void expect_plane(const char* name, const Vector3d& scene_up, const Vector3d& from, const Vector3d& up) {
    const PicturePlane p = parse_plane(name, scene_up);
    EXPECT_LT((viewer(p) - from).norm(), 1e-12) << name;
    EXPECT_LT((p.up - up).norm(), 1e-12) << name;
    EXPECT_EQ(p.origin, Vector3d::Zero());
}

}  // namespace

TEST(PicturePlane, IsSeenFromTheSideThatItIsNamedFor) {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    expect_plane("top", z, z, y);
    expect_plane("bottom", z, -z, -y);
    expect_plane("front", z, -y, z);
    expect_plane("back", z, y, z);
    expect_plane("left", z, -x, z);
    expect_plane("right", z, x, z);
    expect_plane("front", y, z, y);     // as in computer graphics
    expect_plane("front", -y, -z, -y);  // as in photogrammetry
    expect_plane("top", -y, -y, z);
    const Vector3d tilted = Vector3d(0.1, 0.2, 1).normalized();
    for (const char* name : {"top", "bottom", "front", "back", "left", "right"}) {
        const PicturePlane p = parse_plane(name, tilted);
        EXPECT_NEAR(p.right.norm(), 1, 1e-12);
        EXPECT_NEAR(p.right.dot(p.up), 0, 1e-12);
        EXPECT_NEAR(p.right.dot(tilted), 0, 1e-12) << name << ": level";
    }
}

TEST(PicturePlane, MayBeAnyPlane) {
    const PicturePlane p = parse_plane("1,2,3, 0,-5,0, 0,1,2", Vector3d::UnitZ());
    EXPECT_EQ(p.origin, Vector3d(1, 2, 3));
    EXPECT_LT((viewer(p) - Vector3d(0, -1, 0)).norm(), 1e-12);
    EXPECT_LT((p.up - Vector3d(0, 0, 1)).norm(), 1e-12);
    const PicturePlane from_above = parse_plane("0,0,0,0,0,1", Vector3d::UnitZ());
    EXPECT_LT((viewer(from_above) - Vector3d(0, 0, 1)).norm(), 1e-12) << "up is along the normal";
    for (const char* bad : {"", "north", "1,2,3", "0,0,0,0,0,0", "0,0,0,0,0,1,0,0,1", "0,0,0,0,0,1,0,0,0",
                            "0,0,0,nan,0,1", "0,0,0,0,0,1,0,1,0,5", "0,0,0,0,0,1x", "0,0,0,inf,0,1"})
        EXPECT_THROW(parse_plane(bad, Vector3d::UnitZ()), Error) << bad;
}

TEST(PicturePlane, TakesExtentsInItsOwnCoordinates) {
    const Eigen::AlignedBox2d box = parse_extent("-3,0,3.5,5");
    EXPECT_EQ(box.min(), Eigen::Vector2d(-3, 0));
    EXPECT_EQ(box.max(), Eigen::Vector2d(3.5, 5));
    for (const char* bad : {"", "1,2,3", "3,0,-3,5", "0,5,1,5", "0,0,nan,1", "0,0,inf,1"})
        EXPECT_THROW(parse_extent(bad), Error) << bad;
    package::SceneRecord scene{};
    for (int i = 0; i < 3; ++i) scene.bounds_min[i] = 100 * (i + 1), scene.bounds_max[i] = 100 * (i + 1) + 10;
    const Eigen::AlignedBox2d left = extent_on(parse_plane("left", Vector3d::UnitZ()), scene);
    EXPECT_EQ(left.min(), Eigen::Vector2d(-210, 300));
    EXPECT_EQ(left.max(), Eigen::Vector2d(-200, 310));
}

TEST(Orthophoto, CoversItsExtentAndHasASizeThatCanBeWritten) {
    const PicturePlane plane = parse_plane("front", Vector3d::UnitZ());
    const Orthophoto o = orthophoto_of(plane, parse_extent("-3,0,3.5,5"), 0.4);
    EXPECT_EQ(o.width, 17);
    EXPECT_EQ(o.height, 13);
    EXPECT_EQ(o.upper_left, Eigen::Vector2d(-3, 5));
    EXPECT_EQ(orthophoto_of(plane, parse_extent("0,0,1e-9,1e-9"), 1).width, 1);
    EXPECT_THROW(orthophoto_of(plane, parse_extent("0,0,1e9,1"), 1), Error);
    EXPECT_THROW(orthophoto_of(plane, parse_extent("0,0,1,1"), 1e-300), Error);
    EXPECT_EQ(world_file_text({450000, 5400000.5}, 0.25), "0.25\n0\n0\n-0.25\n450000.125\n5400000.375\n");
    for (const int width : {1, 1024, 50000, 1000000}) {
        const TileSize tile = tile_size_for(width);
        EXPECT_LE(4.0 * width * tile.height, 65.0 * (1 << 20)) << width;
        EXPECT_EQ(tile.height % 2, 0);
    }
}
