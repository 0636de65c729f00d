#include "scene/package/contents/background.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <limits>

#include "base/text/error.h"
#include "base/values/bytes_of.h"
#include "scene/package/package_writer.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using package::Type;

namespace {

/// A tetrahedron around the origin, which no photo shows.
BackgroundContent tetrahedron() {
    BackgroundContent s;
    s.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    s.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    s.clusters = {{.center = {0, 0, 0},
                   .radius = 2,
                   .cone_axis = {},
                   .cone_cutoff = 1,
                   .first_triangle = 0,
                   .triangles = 4}};
    s.colors.assign(4, {10, 20, 30, 255});
    return s;
}

struct BackgroundFile : TemporaryFolder {
    std::filesystem::path file = dir / "background.vantage";
    void write(std::span<const std::byte> chunk) {
        std::filesystem::remove(file);
        const std::vector<ChunkPlan> plan{{Type::scene, package::scene_wide, 0, sizeof(package::SceneRecord)},
                                          {Type::photos, package::scene_wide, 0, 0}};
        PackageWriter writer(file, plan);
        writer.write(Type::scene, package::scene_wide, bytes_of_one(package::SceneRecord{}));
        writer.write(Type::photos, package::scene_wide, {});
        writer.append(Type::background, chunk);
        writer.finish();
    }
};

}  // namespace

TEST_F(BackgroundFile, AreReadAsWritten) {
    write(background_chunk(tetrahedron()));
    const auto read = read_background(PackageReader(file));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->positions, tetrahedron().positions);
    EXPECT_EQ(read->triangles, tetrahedron().triangles);
    EXPECT_EQ(read->colors, tetrahedron().colors);
    EXPECT_EQ(read->clusters.front().triangles, 4u);
}

TEST_F(BackgroundFile, ThatContradictThemselvesAreDamaged) {
    const auto expect_damaged = [&](const BackgroundContent& s, const char* what) {
        write(background_chunk(s));
        try {
            read_background(PackageReader(file));
            ADD_FAILURE() << what << ": accepted";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::damaged) << what;
            EXPECT_NE(std::string(e.what()).find("SURR"), std::string::npos) << e.what();
        }
    };
    BackgroundContent s = tetrahedron();
    s.triangles[2][1] = 4;
    expect_damaged(s, "an index beyond the last vertex");
    s = tetrahedron();
    s.positions[0].x() = std::numeric_limits<float>::quiet_NaN();
    expect_damaged(s, "a position that is NaN");
    s = tetrahedron();
    s.clusters[0].triangles = 3;
    expect_damaged(s, "a triangle without cluster");
    s = tetrahedron();
    s.clusters[0].radius = -1;
    expect_damaged(s, "a negative radius");
    s = tetrahedron();
    s.colors.pop_back();
    expect_damaged(s, "a vertex without color");
}

TEST_F(BackgroundFile, OfAnyOtherLengthAreDamaged) {
    const std::vector<std::byte> whole = background_chunk(tetrahedron());
    for (const std::size_t length : {std::size_t(1), sizeof(package::BackgroundRecord), whole.size() - 1}) {
        write(std::span(whole).first(length));
        EXPECT_THROW(read_background(PackageReader(file)), Error) << length;
    }
}
