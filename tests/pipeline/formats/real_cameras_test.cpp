// Camera files written by other programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "tests/datasets.h"
#include "tests/pipeline/formats/exported_cameras.h"
#include "tests/pipeline/formats/exported_scan.h"

namespace vantage {

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

/// The pixel at which a camera images a point.
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
    EXPECT_EQ(tricky.entries[0].camera.lens.model, LensModel::brown) << "because of b2";
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
    EXPECT_NEAR(c.cam_from_world.center().z(), 127.390985712561, 1e-9) << "not the center in its Metadata";
    EXPECT_LT(c.cam_from_world.direction().z(), 0);
    EXPECT_NEAR(c.intrinsics.fx, 9.9001356603859 * 4856 / 13.2, 1e-9);
    EXPECT_THROW(read_cameras(file("blocksexchange/StOriJimmy-libBATools/README.excerpt.xml")), Error);
}

/// The residuals of the markers in a MatchMover file: `ours` are computed here, and `own` are stored in the
/// file.
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
            off.y() *= c.intrinsics.fx / c.intrinsics.fy;  // "re" is in pixel widths
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
