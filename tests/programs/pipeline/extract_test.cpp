// Tests that the output of `vantage extract` is a scan that other programs and `vantage prepare` can read.
#include "pipeline/reports/extract.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>

#include "base/text/photo_names.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/export_colmap.h"
#include "pipeline/formats/export_ply.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/stages/tile_levels.h"
#include "pipeline/synth/synthesize.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/programs/patterns.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Extract : public TemporaryFolder {
  protected:
    const fs::path scan = dir / "scan", files = dir / "files";

    static SynthSpec tiny() {
        SynthSpec spec = tiny_spec();
        return spec;
    }
    void vantage(const std::string& words) const {
        const std::string command = VANTAGE_PROGRAM " " + words + " >" + (dir / "says").string() + " 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << command << '\n' << slurp(dir / "says");
    }
    /// Prepares the scan, extracts the package, and prepares the extracted scan.
    void round_trip(const std::string& options = "", const std::string& again = "") const {
        vantage("prepare " + scan.string() + " -o " + (dir / "first.vantage").string() + " --no-report " +
                options);
        vantage("extract " + (dir / "first.vantage").string() + " -o " + files.string());
        vantage("prepare " + files.string() + " -o " + (dir / "again.vantage").string() +
                " --no-report --refine off " + again);
    }
    PackageReader first() const { return PackageReader(dir / "first.vantage"); }
    PackageReader again() const { return PackageReader(dir / "again.vantage"); }
    /// Moves the whole scan, as if it had map coordinates, and rotates the camera of the photo `wrong` by 4
    /// px.
    void move_scan(const Eigen::Vector3d& by, const std::string& wrong) const {
        std::vector<NamedCamera> cameras;
        for (const CameraSet::Entry& e : read_cameras(scan / "sparse").entries) {
            cameras.push_back({e.photo, e.camera});
            Pose& pose = cameras.back().camera.cam_from_world;
            pose = pose.relative_to(-by);
            if (e.photo != wrong) continue;
            const Eigen::Matrix3d turn =
                Eigen::AngleAxisd(4 / e.camera.intrinsics.fx, Eigen::Vector3d::UnitY()).toRotationMatrix();
            pose = {turn * pose.R, turn * pose.t};
        }
        write_colmap_text(scan / "sparse", cameras);
        std::vector<std::string> warnings;
        const Mesh mesh = read_mesh(scan / "mesh.ply", warnings);
        std::vector<Eigen::Vector3f> positions;
        for (const Eigen::Vector3d& p : mesh.positions) positions.push_back(p.cast<float>());
        write_ply(scan / "mesh.ply", {by, positions, mesh.normals, mesh.triangles});
    }
};

Pose in_world(const PackageReader& package, const package::PhotoRecord& p) {
    return cam_from_origin(p).relative_to(-Eigen::Map<const Eigen::Vector3d>(package.scene().origin));
}

/// The photo with this name in another package; the extension may differ.
const package::PhotoRecord& same_photo(const PackageReader& package, const package::PhotoRecord& p) {
    return package.photos()[package.photo_index(stem_of(p.name)).value()];
}

void expect_same_camera(const PackageReader& a, const package::PhotoRecord& p, const PackageReader& b,
                        const package::PhotoRecord& q) {
    const Pose x = in_world(a, p), y = in_world(b, q);
    EXPECT_LT((x.R - y.R).cwiseAbs().maxCoeff(), 1e-9) << p.name;
    EXPECT_LT((x.t - y.t).cwiseAbs().maxCoeff(), 1e-9) << p.name;
    EXPECT_LT((x.center() - y.center()).norm(), 1e-9) << p.name;
    EXPECT_EQ(p.width, q.width);
    EXPECT_EQ(p.height, q.height);
    for (const auto value : {&package::PhotoRecord::fx, &package::PhotoRecord::fy, &package::PhotoRecord::cx,
                             &package::PhotoRecord::cy})
        EXPECT_EQ(p.*value, q.*value) << p.name;
}

}  // namespace

TEST_F(Extract, FolderIsAScanWithTheSamePhotosAndRefinedCameras) {
    SynthSpec spec = tiny();
    spec.photos.width = 800;
    spec.photos.height = 600;
    spec.photos.arc = 40;
    spec.lens.k1 = -0.1;
    copy_scene(spec, scan);
    const Eigen::Vector3d far(3000, -2000, 500);
    move_scan(far, "0003.jpg");
    round_trip("--effect pose-refinement=on --hold-out 0000");
    const PackageReader a = first(), b = again();
    ASSERT_EQ(b.photos().size(), 4u) << "the held-out photo should have no pixels";
    const CameraSet given = read_cameras(scan / "sparse");
    double moved = 0;
    for (const package::PhotoRecord& p : a.photos()) {
        if (p.levels == 0) continue;
        const package::PhotoRecord& q = same_photo(b, p);
        expect_same_camera(a, p, b, q);
        const auto of_p = [&](const CameraSet::Entry& e) { return e.photo == p.name; };
        const Pose before = std::ranges::find_if(given.entries, of_p)->camera.cam_from_world;
        EXPECT_LT((before.center() - in_world(a, p).center()).norm(), 0.5)
            << "the extracted poses should be in the input's coordinates";
        moved = std::max(moved, (before.R - in_world(a, p).R).norm());
        // Pixels that do not show the mesh are kept. JPEG compression may round colors twice.
        const auto pixels = [](const PackageReader& r, const package::PhotoRecord& photo) {
            return read_level_image(r, photo, std::uint32_t(&photo - r.photos().data()), package::Type::tiles,
                                    0)
                .rgba;
        };
        const auto x = pixels(a, p), y = pixels(b, q);
        ASSERT_EQ(x.size(), y.size());
        std::size_t alpha = 0, far = 0;
        for (std::size_t k = 0; k < x.size(); ++k)
            (k % 4 == 3 ? alpha : far) += std::abs(int(x[k]) - int(y[k])) > (k % 4 == 3 ? 0 : 8);
        EXPECT_EQ(alpha, 0u) << p.name;
        EXPECT_LT(double(far), 0.01 * double(x.size())) << p.name;
    }
    EXPECT_GT(moved, 0.001) << "the poses should be the corrected ones";
}

TEST_F(Extract, PhotosAreAsTakenOrUndistorted) {
    SynthSpec spec = tiny();
    spec.lens.k1 = -0.1;
    copy_scene(spec, scan);
    round_trip();
    const PackageReader a = first();
    for (std::uint32_t i = 0; i < a.photos().size(); ++i)
        EXPECT_EQ(lens_of(a, i).p, lens_of(again(), i).p) << "the lens should be extracted with the photos";
    const std::string package = (dir / "first.vantage").string();
    const fs::path straight = dir / "straight";
    vantage("extract " + package + " -o " + straight.string() + " --undistorted");
    vantage("prepare " + straight.string() + " -o " + (dir / "straight.vantage").string() +
            " --no-report --refine off");
    const PackageReader s(dir / "straight.vantage");
    EXPECT_EQ(s.find(package::Type::lenses), nullptr);
    // A point at the frame's corner moves by k1 r^2, so the two pictures differ only there.
    const auto pixels = [](const PackageReader& r) {
        return read_level_image(r, r.photos()[0], 0, package::Type::tiles, 0);
    };
    const RgbaImage taken = pixels(a), undistorted = pixels(s);
    const auto differs = [&](int x, int y) {
        int most = 0;
        for (int j = -4; j <= 4; ++j)
            for (int c = 0; c < 3; ++c) {
                const std::size_t at =
                    4 * (std::size_t(y + j) * std::size_t(taken.width) + std::size_t(x)) + std::size_t(c);
                most = std::max(most, std::abs(int(taken.rgba[at]) - int(undistorted.rgba[at])));
            }
        return most;
    };
    EXPECT_LE(differs(taken.width / 2, taken.height / 2), 12);
    EXPECT_THROW(extract(package, straight, {"0001"}), Error) << "the folder contains undistorted photos";
    EXPECT_THROW(extract(package, files, {"0001"}, true), Error) << "the folder contains photos as taken";
}

TEST_F(Extract, FolderOfImageSetsHasTheSameImageSets) {
    SynthSpec spec = tiny();
    spec.infrared.count = 4;
    spec.infrared.width = 260;
    spec.infrared.height = 200;
    copy_scene(spec, scan);
    round_trip();
    const PackageReader a = first(), b = again();
    ASSERT_EQ(b.photos().size(), 9u);
    const auto image_sets = read_image_sets(a), others = read_image_sets(b);
    ASSERT_EQ(others.size(), 2u);
    for (const package::PhotoRecord& p : a.photos()) {
        const package::PhotoRecord& q = same_photo(b, p);
        EXPECT_EQ(image_sets[p.image_set].name, others[q.image_set].name) << p.name;
        expect_same_camera(a, p, b, q);
    }
}

TEST_F(Extract, FolderWithoutMeshIsAPointCloudWithItsPhotos) {
    copy_scene(tiny(), scan);
    std::vector<std::string> warnings;
    const Mesh mesh = read_mesh(scan / "mesh.ply", warnings);
    fs::remove(scan / "mesh.ply");
    write_points_ply(scan / "cloud.ply", mesh.positions.size(), [&](const auto& put) {
        for (const Eigen::Vector3d& p : mesh.positions) put({p, {200, 150, 100}});
    });
    round_trip();
    const PackageReader a = first(), b = again();
    EXPECT_TRUE(points_only(b.scene()));
    ASSERT_EQ(b.photos().size(), 5u);
    for (const package::PhotoRecord& p : a.photos()) expect_same_camera(a, p, b, same_photo(b, p));
}

TEST_F(Extract, TheMeshIsSaidToBeThatOfThePackageWithLargeTrianglesDivided) {
    copy_scene(tiny(), scan);
    std::vector<std::string> warnings;
    const std::size_t given = read_mesh(scan / "mesh.ply", warnings).triangles.size();
    const std::string package = (dir / "first.vantage").string();
    vantage("prepare " + scan.string() + " -o " + package + " --no-report");
    vantage("extract " + package + " -o " + files.string());
    const Mesh mesh = read_mesh(files / "mesh.ply", warnings);
    EXPECT_GT(mesh.triangles.size(), given);
    const std::string says = slurp(dir / "says");
    EXPECT_NE(
        says.find(std::to_string(mesh.triangles.size()) + " triangles: as prepared, with the input's large "
                                                          "triangles divided"),
        std::string::npos)
        << says;
    EXPECT_NE(says.find("photos (5)"), std::string::npos) << says;
}

TEST_F(Extract, CamerasAreThoseOfThePhotosInTheFolder) {
    copy_scene(tiny(), scan);
    const std::string package = (dir / "first.vantage").string();
    vantage("prepare " + scan.string() + " -o " + package + " --no-report --hold-out 0004");
    const auto named = [&] {
        std::vector<std::string> names;
        for (const CameraSet::Entry& e : read_cameras(files / "sparse").entries) names.push_back(e.photo);
        return names;
    };
    vantage("extract " + package + " -o " + files.string() + " --photo 0003");
    EXPECT_EQ(named().size(), 1u);
    vantage("extract " + package + " -o " + files.string());
    EXPECT_EQ(named().size(), 4u);
    vantage("extract " + package + " -o " + files.string() + " --photo 0003");
    EXPECT_EQ(named().size(), 4u) << "the other photos should be kept";
    for (const CameraSet::Entry& e : read_cameras(files / "sparse").entries)
        EXPECT_TRUE(fs::exists(files / "photos" / e.photo)) << e.photo;
    // The cameras are in the form that COLMAP reads: three files, two lines per image, and numbers separated
    // by single spaces.
    EXPECT_TRUE(fs::exists(files / "sparse" / "points3D.txt"));
    const std::string images = slurp(files / "sparse" / "images.txt");
    EXPECT_EQ(matches(images, "\\d+( -?[0-9.e-]+){7} \\d+ 000[0-3]\\.jpg\n\n").size(), 4u);
    EXPECT_THROW(extract(package, files, {"0004"}), Error) << "has no pixels";
}
