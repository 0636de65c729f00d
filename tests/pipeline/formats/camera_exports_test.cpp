// The same cameras as other programs export them, and files that these programs have written.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <random>
#include <sstream>

#include "base/files/png_file.h"
#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "tests/datasets.h"
#include "tests/pipeline/formats/exported_cameras.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using exported::Photo;

Eigen::Matrix3d random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
}

/// Cameras all around, with lenses of their own, two of them portrait.
std::vector<Photo> some_photos() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> one(-1, 1);
    std::vector<Photo> out;
    for (int i = 0; i < 7; ++i) {
        Photo p{"IMG_" + std::to_string(8000 + i) + ".png",
                64,
                48,
                60 + 5 * one(random),
                0,
                32 + one(random),
                24 + one(random)};
        if (i % 3 == 2) std::swap(p.width, p.height), std::swap(p.cx, p.cy);
        p.fy = p.fx * (1 + 0.02 * one(random));
        p.k1 = 0.1 * one(random), p.k2 = 0.02 * one(random), p.k3 = 0.005 * one(random);
        p.p1 = 0.004 * one(random), p.p2 = 0.004 * one(random);
        p.R = random_rotation(random);
        p.center = 5 * Eigen::Vector3d(one(random), one(random), one(random));
        out.push_back(p);
    }
    return out;
}

/// Photos that fit one focal length in both directions.
std::vector<Photo> with_square_pixels(std::vector<Photo> photos) {
    for (Photo& p : photos) p.fy = p.fx;
    return photos;
}

class CameraExports : public TemporaryFolder {
  protected:
    void put(const fs::path& name, const std::string& text) {
        fs::create_directories((dir / name).parent_path());
        std::ofstream(dir / name, std::ios::binary) << text;
    }
    void put_photos(const std::vector<Photo>& photos) {
        fs::create_directories(dir / "images");
        for (const Photo& p : photos) {
            const std::vector<std::uint8_t> gray(std::size_t(p.width * p.height) * 4, 128);
            write_png(dir / "images" / p.name, p.width, p.height, gray);
        }
        put("mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    }
    /// Reads the folder as prepare does, and compares with the truth.
    void expect_cameras(const std::vector<Photo>& photos, const std::string& format) {
        const SceneInput scene = read_scene(discover(dir));
        EXPECT_EQ(scene.camera_format, format);
        ASSERT_EQ(scene.photos.size(), photos.size()) << format;
        for (std::size_t i = 0; i < photos.size(); ++i) expect_camera(scene.photos[i], photos[i], format);
    }
    static void expect_camera(const PhotoInput& read, const Photo& p, const std::string& format) {
        const Camera& c = read.camera;
        const Intrinsics& k = c.intrinsics;
        EXPECT_EQ(read.name, p.name) << format;
        EXPECT_EQ(k.width, p.width) << format;
        EXPECT_EQ(k.height, p.height) << format;
        EXPECT_LT((c.cam_from_world.R - p.R).norm(), 1e-9) << format << ' ' << p.name;
        EXPECT_LT((c.cam_from_world.center() - p.center).norm(), 1e-9) << format << ' ' << p.name;
        EXPECT_LT(std::abs(k.fx - p.fx) + std::abs(k.fy - p.fy), 1e-9) << format << ' ' << p.name;
        EXPECT_LT(std::abs(k.cx - p.cx) + std::abs(k.cy - p.cy), 1e-9) << format << ' ' << p.name;
        for (const Eigen::Vector2d& q : {Eigen::Vector2d(0.3, -0.2), {-0.4, 0.1}, {0.2, 0.35}})
            EXPECT_LT((distort(c.lens, q) - distorted(p, q)).norm(), 1e-12) << format << ' ' << p.name;
    }
    /// OpenCV's equations, written out again.
    static Eigen::Vector2d distorted(const Photo& p, const Eigen::Vector2d& q) {
        const double x = q.x(), y = q.y(), r2 = x * x + y * y,
                     radial = 1 + p.k1 * r2 + p.k2 * r2 * r2 + p.k3 * r2 * r2 * r2;
        return {x * radial + 2 * p.p1 * x * y + p.p2 * (r2 + 2 * x * x),
                y * radial + p.p1 * (r2 + 2 * y * y) + 2 * p.p2 * x * y};
    }
};

}  // namespace

TEST_F(CameraExports, ColmapIsRead) {
    const auto photos = some_photos();
    put_photos(photos);
    put("sparse/0/cameras.txt", exported::colmap_cameras(photos));
    put("sparse/0/images.txt", exported::colmap_images(photos));
    expect_cameras(photos, "COLMAP text");
}

TEST_F(CameraExports, MetashapeIsReadWithItsChunkTransform) {
    const auto photos = some_photos();
    put_photos(photos);
    std::mt19937 random(2);
    put("cameras.xml", exported::metashape(photos, random_rotation(random), {400, -30, 7}, 3.7));
    expect_cameras(photos, "Metashape");
}

TEST_F(CameraExports, RealityCaptureSidecarsAreReadInBothForms) {
    const auto photos = some_photos();
    put_photos(photos);
    for (std::size_t i = 0; i < photos.size(); ++i)
        put("images/" + fs::path(photos[i].name).stem().string() + ".xmp",
            exported::realitycapture_xmp(photos[i], i % 2 == 0));
    expect_cameras(photos, "RealityCapture XMP");
}

TEST_F(CameraExports, RealityCaptureTableIsReadByItsHeader) {
    const auto photos = with_square_pixels(some_photos());
    put_photos(photos);
    put("cameras.csv", exported::realitycapture_csv(photos));
    expect_cameras(photos, "RealityCapture CSV");
}

TEST_F(CameraExports, MeshroomIsRead) {
    const auto photos = some_photos();
    put_photos(photos);
    put("cameras.sfm", exported::meshroom(photos));
    expect_cameras(photos, "Meshroom");
}

TEST_F(CameraExports, OpenMvgIsRead) {
    const auto photos = with_square_pixels(some_photos());
    put_photos(photos);
    put("sfm_data.json", exported::openmvg(photos));
    expect_cameras(photos, "OpenMVG");
}

TEST_F(CameraExports, OpenSfmIsRead) {
    const auto photos = some_photos();
    put_photos(photos);
    put("opensfm/reconstruction.json", exported::opensfm(photos));
    expect_cameras(photos, "OpenSfM");
}

TEST_F(CameraExports, TransformsAreReadBeforeWhatWasApplied) {
    const auto photos = some_photos();
    put_photos(photos);
    std::mt19937 random(3);
    put("transforms.json", exported::transforms(photos, random_rotation(random), {1, 2, -3}));
    expect_cameras(photos, "transforms.json");
}

TEST_F(CameraExports, BlocksExchangeIsReadWithItsAxes) {
    const auto photos = some_photos();
    put_photos(photos);
    put("block.xml", exported::blocks_exchange(photos));
    expect_cameras(photos, "Blocks Exchange");
}

TEST_F(CameraExports, WhatCannotBeReadIsSaidInOneLineWithItsPlace) {
    const auto photos = some_photos();
    const auto cut = [](std::string text, const std::string& old, const std::string& with) {
        const std::size_t at = text.find(old);
        EXPECT_NE(at, text.npos) << old;
        return text.replace(at, old.size(), with);
    };
    struct Case {
        const char* file;
        std::string text, expected;
    };
    const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const Case cases[] = {
        {"m.xml", cut(exported::metashape(photos, none, zero, 1), "<k1>", "<k1>x"),
         "line 8: <k1>: expected a number, found 'x"},
        {"m.xml", cut(exported::metashape(photos, none, zero, 1), "</document>", ""), "is not XML"},
        {"t.json", cut(exported::transforms(photos, none, zero), "\"fl_x\": ", "\"fl_x\": \"a\"+"),
         "is not JSON"},
        {"t.json", cut(exported::transforms(photos, none, zero), "OPENCV", "FISHY"),
         "camera_model: found \"FISHY\", expected OPENCV"},
        {"o.json", cut(exported::openmvg(photos), "pinhole_brown_t2", "spherical"), "not 'spherical'"},
        {"s.json", cut(exported::opensfm(photos), "brown", "spherical"), "expected perspective, brown"},
        {"b.xml", cut(exported::blocks_exchange(photos), "XLeftYUp", "Sideways"), "found 'Sideways'"},
        {"r.csv", cut(exported::realitycapture_csv(photos), ",heading,pitch,roll,", ",omega,phi,kappa,"),
         "whose meaning differs"},
        {"r.csv", cut(exported::realitycapture_csv(photos), ",f,px", ",g,px"), "a focal length"},
        {"r.csv", cut(exported::realitycapture_csv(photos), "#name,", "#name,name,name,"),
         "expected 18 columns, found 16"},
        {"c.sfm", cut(exported::meshroom(photos), "\"brown\"", "\"3deradial4\""), "expected none, radialk1"}};
    for (const Case& c : cases) {
        put(c.file, c.text);
        try {
            read_cameras(dir / c.file);
            ADD_FAILURE() << c.file << " is read; expected: " << c.expected;
        } catch (const Error& e) {
            const std::string what = e.what();
            EXPECT_NE(what.find(c.expected), what.npos) << what;
            EXPECT_EQ(what.find('\n'), what.npos) << what;
            EXPECT_NE(what.find(c.file), what.npos) << what;
        }
    }
}

// Files that the programs themselves have written.

class RealCameras : public CameraExports {
  protected:
    void SetUp() override {
        CameraExports::SetUp();
        VANTAGE_DATASET(cameras, "cameras");
        folder_ = cameras;
    }
    fs::path file(const std::string& name) const { return folder_ / name; }

  private:
    fs::path folder_;
};

namespace {

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
    return values[values.size() / 2];
}

/// Where a camera's lens images a point.
Eigen::Vector2d imaged(const Camera& c, const Eigen::Vector3d& point) {
    const Eigen::Vector3d p = c.cam_from_world.R * point + c.cam_from_world.t;
    const Eigen::Vector2d d = distort(c.lens, p.hnormalized());
    return {c.intrinsics.fx * d.x() + c.intrinsics.cx, c.intrinsics.fy * d.y() + c.intrinsics.cy};
}

nlohmann::json json_of(const fs::path& file) { return nlohmann::json::parse(std::ifstream(file)); }

Eigen::Vector3d vector_of(const nlohmann::json& j) {
    return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

}  // namespace

TEST_F(RealCameras, MetashapePositionsAreThoseOfTheSatelliteReceiver) {
    const fs::path road = file("metashape/KU-Leuven-Geomatics-geomapi/road.xml");
    pugi::xml_document document;
    ASSERT_TRUE(document.load_file(road.c_str()));
    std::map<std::string, Eigen::Vector3d> measured;
    for (const pugi::xml_node c : document.child("document").child("chunk").child("cameras").children())
        if (const pugi::xml_node r = c.child("reference"))
            measured[c.attribute("label").value()] = {
                r.attribute("x").as_double(), r.attribute("y").as_double(), r.attribute("z").as_double()};
    const CameraSet set = read_cameras(road);
    ASSERT_EQ(set.entries.size(), 78u);
    std::vector<double> off;
    for (const CameraSet::Entry& e : set.entries)
        off.push_back((e.camera.cam_from_world.center() - measured.at(e.photo)).norm());
    EXPECT_LT(median(off), 0.02) << "meters";
}

TEST_F(RealCameras, MetashapeFilesOfAllKindsAreReadOrSayWhyNot) {
    const CameraSet railway = read_cameras(file("metashape/KU-Leuven-Geomatics-geomapi/railway.xml"));
    EXPECT_EQ(railway.entries.size(), 191u);
    EXPECT_NEAR(railway.entries[0].camera.intrinsics.fx, 21963.0445544689 + 97.8391122564925, 1e-9);
    EXPECT_NEAR(railway.entries[0].camera.intrinsics.cx, 5832 - 7.37477481323126, 1e-9);
    const CameraSet tricky = read_cameras(file("metashape/bitbyt3r-metashape-automation/cameras.xml"));
    EXPECT_GT(tricky.entries.size(), 80u);
    EXPECT_EQ(tricky.entries[0].camera.lens.model, LensModel::brown) << "it has b2";
    const CameraSet old = read_cameras(file("metashape/amarburg-photoscan_outputs/cameras.xml"));
    EXPECT_EQ(old.entries.size(), 16u);
    EXPECT_EQ(old.entries[0].camera.intrinsics.cx, 525.86579873845619);
    EXPECT_THROW(read_cameras(file("metashape/hwiyoung-MappingLocalization/cameras.xml")), Error);
}

TEST_F(RealCameras, OpenMvgPointsProjectToWhereTheyWereSeen) {
    const fs::path path = file("openmvg/naver-kapture-maupertuis/sfm_data.json");
    const CameraSet set = read_cameras(path);
    ASSERT_EQ(set.entries.size(), 4u);
    const nlohmann::json points = json_of(path).at("structure");
    std::vector<double> off;
    for (const auto& point : points)
        for (const auto& seen : point.at("value").at("observations")) {
            const auto& x = seen.at("value").at("x");
            const Eigen::Vector2d pixel(double(x.at(0)) + 0.5, double(x.at(1)) + 0.5);
            const Camera& c = set.entries.at(seen.at("key")).camera;
            off.push_back((imaged(c, vector_of(point.at("value").at("X"))) - pixel).norm());
        }
    ASSERT_GT(off.size(), 1000u);
    EXPECT_LT(median(off), 0.35) << "pixels";
    EXPECT_EQ(read_cameras(file("openmvg/naver-kapture-t265/sfm_data_small.json")).entries.size(), 5u);
}

TEST_F(RealCameras, OpenSfmPointsLieInFrontOfCamerasAndInPhotos) {
    for (const char* name : {"opensfm/mapillary-OpenSfM/reconstruction_example.json",
                             "odm/testerarm-result1/reconstruction.json"}) {
        const CameraSet set = read_cameras(file(name));
        EXPECT_EQ(set.entries.size(), std::string(name).starts_with("odm") ? 6u : 3u);
        const auto points = json_of(file(name)).at(0).at("points");
        for (const CameraSet::Entry& e : set.entries) {
            int inside = 0;
            for (const auto& p : points) {
                const Eigen::Vector3d point = vector_of(p.at("coordinates"));
                const bool in_front = (e.camera.cam_from_world.R * point + e.camera.cam_from_world.t).z() > 0;
                inside += in_front && in_frame(e.camera.intrinsics, imaged(e.camera, point));
            }
            EXPECT_GT(inside, int(points.size()) / 4) << name << ' ' << e.photo;
        }
    }
}

TEST_F(RealCameras, MeshroomReadsEveryVersionAlike) {
    const char* const versions[] = {"1.2.0", "1.2.1", "1.2.2", "1.2.3", "1.2.4",
                                    "1.2.5", "1.2.6", "1.2.8", "1.2.11"};
    for (const std::string version : versions) {
        const CameraSet set = read_cameras(file("alicevision/alicevision-AliceVision-compatibilityData-cut") /
                                           ("scene_v" + version + ".cut.json"));
        ASSERT_EQ(set.entries.size(), 54u) << version;
        const Camera& c = set.entries.back().camera;
        EXPECT_NEAR(c.intrinsics.fx, 1000, 1e-6) << version;
        EXPECT_NEAR(c.intrinsics.fy, 2000, 1e-6) << version;
        EXPECT_NEAR(c.intrinsics.cx, 2020, 1e-9) << version;
        EXPECT_NEAR(c.intrinsics.cy, 1040, 1e-9) << version;
        EXPECT_EQ(c.lens.p[0], 0.1) << version;
    }
    EXPECT_THROW(read_cameras(file("alicevision/alicevision-AliceVision/small.sfm")), Error);
}

TEST_F(RealCameras, TransformsTurnAsTheColmapModelTheyWereMadeFrom) {
    const fs::path folder = file("transforms/sangminkim-99-COLMAP_multicam");
    fs::copy_file(folder / "cameras.txt", dir / "cameras.txt");
    fs::copy_file(folder / "images.cut.txt", dir / "images.txt");
    const CameraSet colmap = read_cameras(dir), set = read_cameras(folder / "transforms.json");
    ASSERT_EQ(set.entries.size(), 42u);
    std::map<std::string, Pose> poses;
    for (const CameraSet::Entry& e : colmap.entries)
        poses[fs::path(e.photo).filename().string()] = e.camera.cam_from_world;
    const auto pose_of = [&](const CameraSet::Entry& e) {
        return poses.at(fs::path(e.photo).filename().string());
    };
    const CameraSet::Entry& first = set.entries.front();
    const Eigen::Matrix3d turn = first.camera.cam_from_world.R.transpose() * pose_of(first).R;
    for (const CameraSet::Entry& e : set.entries)
        EXPECT_LT((e.camera.cam_from_world.R * turn - pose_of(e).R).norm(), 1e-6) << e.photo;
    EXPECT_EQ(read_cameras(file("transforms/NVlabs-instant-ngp/transforms.json")).entries.size(), 67u);
    const CameraSet lego =
        read_cameras(file("transforms/nerfstudio-project-nerfstudio/transforms_train.json"));
    EXPECT_EQ(lego.entries.at(0).unit, CameraSet::Unit::photo_width);
}

TEST_F(RealCameras, RealityCaptureSidecarsStandWhereItsTableSays) {
    const fs::path folder = file("realitycapture/KU-Leuven-Geomatics-geomapi");
    const CameraSet set = read_cameras(folder);
    ASSERT_EQ(set.entries.size(), 2u);
    std::ifstream table(folder / "parking.csv");
    int found = 0;
    for (std::string line; std::getline(table, line);)
        for (const CameraSet::Entry& e : set.entries) {
            if (!line.starts_with(e.photo + ".")) continue;
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream in(line);
            std::string name;
            Eigen::Vector3d center;
            in >> name >> center.x() >> center.y() >> center.z();
            EXPECT_LT((e.camera.cam_from_world.center() - center).norm(), 1e-9) << name;
            ++found;
        }
    EXPECT_EQ(found, 2);
    EXPECT_THROW(read_cameras(folder / "parking.csv"), Error) << "it has no focal length";
}

TEST_F(RealCameras, BlocksExchangeLooksDownFromTheAir) {
    const CameraSet set =
        read_cameras(file("blocksexchange/GDAOSU-albedo_aerial_photogrammetry/"
                          "dataset_preprocessing.excerpt.xml"));
    ASSERT_EQ(set.entries.size(), 1u);
    const Camera& c = set.entries[0].camera;
    EXPECT_NEAR(c.cam_from_world.center().z(), 127.390985712561, 1e-9) << "not that of its Metadata";
    EXPECT_LT(c.cam_from_world.direction().z(), 0);
    EXPECT_NEAR(c.intrinsics.fx, 9.9001356603859 * 4856 / 13.2, 1e-9);
    EXPECT_THROW(read_cameras(file("blocksexchange/StOriJimmy-libBATools/README.excerpt.xml")), Error);
}

/// The residuals of a MatchMover file's markers: ours and its own.
struct Residuals {
    std::vector<double> ours, own;
};

namespace {

Residuals residuals_of(const fs::path& path) {
    const CameraSet set = read_cameras(path);
    pugi::xml_document document;
    document.load_file(path.c_str());
    const pugi::xml_node root = document.child("RZML"), shot = root.child("SHOT");
    std::map<int, Eigen::Vector3d> points;
    for (const pugi::xpath_node l : root.select_nodes("//L")) {
        const pugi::xml_node p = l.node().child("P");
        if (p)
            points[l.node().attribute("i").as_int()] = {
                p.attribute("x").as_double(), p.attribute("y").as_double(), p.attribute("z").as_double()};
    }
    std::map<int, const Camera*> cameras;
    std::size_t i = 0;
    for (const pugi::xml_node f : shot.children("CFRM"))
        cameras[f.attribute("t").as_int()] = &set.entries.at(i++).camera;
    Residuals out;
    for (const pugi::xml_node f : shot.child("IPLN").children("IFRM"))
        for (const pugi::xml_node m : f.children("M")) {
            const auto camera = cameras.find(f.attribute("t").as_int());
            const auto point = points.find(m.attribute("i").as_int());
            if (camera == cameras.end() || point == points.end() || !m.attribute("re")) continue;
            const Camera& c = *camera->second;
            Eigen::Vector2d off = imaged(c, point->second) -
                                  Eigen::Vector2d(m.attribute("x").as_double(), m.attribute("y").as_double());
            off.y() *= c.intrinsics.fx / c.intrinsics.fy;  // "re" counts in the width of pixels
            out.ours.push_back(off.norm());
            out.own.push_back(m.attribute("re").as_double());
        }
    return out;
}

}  // namespace

TEST_F(RealCameras, MatchMoverMarkersAreAsFarOffAsTheFileSays) {
    struct Case {
        const char* file;
        double median;
    };
    for (const Case c : {Case{"nearNodalSolve_animatedDistortion_timeRange", 1.24},
                         {"staticSlightDistortion_pixelAspectRatio", 0.19},
                         {"normalCameraSolve_pixelAspectRatio", 0.24}}) {
        const Residuals r = residuals_of(file("matchmover/david-cattermole-matchmover-distortion-tool") /
                                         (std::string(c.file) + ".rzml"));
        ASSERT_GT(r.ours.size(), 1000u) << c.file;
        std::vector<double> between;
        for (std::size_t i = 0; i < r.ours.size(); ++i) between.push_back(std::abs(r.ours[i] - r.own[i]));
        EXPECT_NEAR(median(r.ours), c.median, 0.005) << c.file;
        EXPECT_LT(median(between), 0.01) << c.file << ", " << r.ours.size() << " markers";
        RecordProperty(std::string(c.file) + "_markers", int(r.ours.size()));
    }
}

TEST_F(RealCameras, ColmapWithRigsIsRead) {
    EXPECT_EQ(read_cameras(file("colmap/yinsy83-final-task-1")).entries.size(), 2u);
}

}  // namespace vantage
