// Tests that a real scan gives the same package if its cameras are in the formats of other programs.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "pipeline/formats/cameras/cameras.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/pipeline/formats/exported_cameras.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using exported::Photo;

class CameraFormats : public TemporaryFolder {
  protected:
    int run(const std::string& words) const {
        const int status =
            std::system((VANTAGE_PROGRAM " " + words + " >" + (dir / "says").string() + " 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    fs::path package(const std::string& name) const { return dir / (name + ".vantage"); }
    /// Prepares the scan with these files as its camera files. The background is off, because its depths may
    /// depend on the last digits of a pose.
    void prepare(const std::string& name, const std::map<std::string, std::string>& files,
                 const fs::path& scan) const {
        fs::create_directories(dir / name);
        fs::create_symlink(scan / "images", dir / name / "images");
        fs::create_symlink(scan / "mesh.ply", dir / name / "mesh.ply");
        for (const auto& [file, text] : files) std::ofstream(dir / name / file, std::ios::binary) << text;
        ASSERT_EQ(run("prepare " + (dir / name).string() + " -o " + package(name).string() +
                      " --no-report --refine off --effect background=off --max-photo-size 640"),
                  0)
            << slurp(dir / "says");
    }
    /// Compares poses with a tolerance of 1e-9, and everything else bit by bit.
    void expect_equal(const std::string& a, const std::string& b) const {
        const PackageReader one(package(a)), other(package(b));
        ASSERT_EQ(one.photos().size(), other.photos().size()) << b;
        for (std::size_t i = 0; i < one.photos().size(); ++i) {
            const Pose p = cam_from_origin(one.photos()[i]), q = cam_from_origin(other.photos()[i]);
            EXPECT_LT((p.R - q.R).norm(), 1e-9) << b << ", photo " << i;
            EXPECT_LT((p.center() - q.center()).norm(), 1e-9) << b << ", photo " << i;
        }
        run("diff " + package(a).string() + " " + package(b).string());
        std::istringstream differences(slurp(dir / "says"));
        for (std::string line; std::getline(differences, line);)
            EXPECT_TRUE(line.starts_with("inputs: ") || line.starts_with("settings: align: ") ||
                        line.ends_with(": camera: different"))
                << b << ": " << line;
    }
};

std::vector<Photo> photos_of(const fs::path& sparse) {
    std::vector<Photo> out;
    for (const CameraSet::Entry& e : read_cameras(sparse).entries) {
        const Intrinsics& k = e.camera.intrinsics;
        Photo p{e.photo, k.width, k.height, k.fx, k.fy, k.cx, k.cy};
        p.R = e.camera.cam_from_world.R;
        p.center = e.camera.cam_from_world.center();
        out.push_back(p);
    }
    return out;
}

struct Format {
    const char *name, *same_as;  ///< "square": the format stores a single focal length for x and y
    std::map<std::string, std::string> files;
};

class CameraFormatsAtLength : public CameraFormats {};

TEST_F(CameraFormatsAtLength, MakeTheSamePackage) {
    VANTAGE_DATASET(scan, "fountain-P11");
    const fs::path real = fs::absolute(scan);
    const std::vector<Photo> photos = photos_of(real / "sparse");
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
    std::map<std::string, std::string> sidecars;
    for (const Photo& p : photos)
        sidecars[fs::path(p.name).stem().string() + ".xmp"] = exported::realitycapture_xmp(p, false);
    std::vector<Photo> square = photos;
    for (Photo& p : square) p.fy = p.fx;
    for (const auto& [name, of] : {std::pair{"colmap", photos}, {"square", square}})
        prepare(name,
                {{"cameras.txt", exported::colmap_cameras(of)}, {"images.txt", exported::colmap_images(of)}},
                real);
    const Format formats[] = {
        {"metashape", "colmap", {{"cameras.xml", exported::metashape(photos, turn, {30, -4, 7}, 2.5)}}},
        {"sidecars", "colmap", sidecars},
        {"table", "square", {{"cameras.csv", exported::realitycapture_csv(square)}}},
        {"meshroom", "colmap", {{"cameras.sfm", exported::meshroom(photos)}}},
        {"openmvg", "square", {{"sfm_data.json", exported::openmvg(square)}}},
        {"opensfm", "colmap", {{"reconstruction.json", exported::opensfm(photos)}}},
        {"transforms", "colmap", {{"transforms.json", exported::transforms(photos, turn, {0, 1, 2})}}},
        {"blocks", "colmap", {{"block.xml", exported::blocks_exchange(photos)}}}};
    for (const Format& f : formats) {
        prepare(f.name, f.files, real);
        expect_equal(f.same_as, f.name);
    }
}

TEST_F(CameraFormats, CamerasOfAnotherFrameAreMovedByTheSceneFile) {
    VANTAGE_DATASET(scan, "sceaux-small");
    const fs::path real = fs::absolute(scan);
    std::vector<Photo> photos = photos_of(real / "sparse");
    prepare(
        "given",
        {{"cameras.txt", exported::colmap_cameras(photos)}, {"images.txt", exported::colmap_images(photos)}},
        real);
    // x = 2 T y + (5, -3, 400) transforms points y of the other frame to the mesh's frame; T permutes the
    // axes.
    Eigen::Matrix3d T;
    T << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    for (Photo& p : photos) {
        p.R = p.R * T;
        p.center = T.transpose() * (p.center - Eigen::Vector3d(5, -3, 400)) / 2;
    }
    fs::create_directories(dir / "other");
    std::ofstream(dir / "other/cameras.txt") << exported::colmap_cameras(photos);
    std::ofstream(dir / "other/images.txt") << exported::colmap_images(photos);
    std::ofstream(dir / "moved.toml")
        << "[[object]]\nname = \"moved\"\ncameras = \"other\"\nmesh = \"given/mesh.ply\"\n"
           "photos = \"given/images\"\n"
           "align = [[0, 0, 2, 5], [2, 0, 0, -3], [0, 2, 0, 400]]\n";
    ASSERT_EQ(run("prepare " + (dir / "moved.toml").string() + " -o " + (dir / "out").string() +
                  " --no-report --refine off --effect background=off --max-photo-size 640"),
              0)
        << slurp(dir / "says");
    fs::rename(dir / "out/moved.vantage", package("moved"));
    expect_equal("given", "moved");
}

}  // namespace
}  // namespace vantage
