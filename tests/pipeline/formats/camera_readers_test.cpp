// Camera files like those of users: with unused cameras, without cameras, or with other contents.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>

#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/cameras/realitycapture/realitycapture.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

class CameraReaders : public TemporaryFolder {
  protected:
    fs::path put(const std::string& name, const std::string& text) const {
        std::ofstream(dir / name, std::ios::binary) << text;
        return dir / name;
    }
    fs::path put_transforms(const std::string& keys) const {
        return put("transforms.json",
                   "{" + keys +
                       ", \"frames\": [{\"file_path\": \"a.jpg\", "
                       "\"transform_matrix\": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}]}");
    }
    /// Expects an error of type E whose message contains `words`.
    template <class E = Error>
    static void expect_error(const fs::path& cameras, const std::string& words) {
        try {
            read_cameras(cameras);
            ADD_FAILURE() << cameras << " was accepted; expected: " << words;
        } catch (const E& e) {
            EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
        }
    }
};

TEST_F(CameraReaders, ColmapCameraHasAsManyParametersAsItsModel) {
    put("images.txt", "1 1 0 0 0 0 0 0 1 a.jpg\n\n");
    put("cameras.txt", "1 SIMPLE_PINHOLE 640 480 500 320 240 # of all photos\n");
    EXPECT_EQ(read_cameras(dir).entries.at(0).camera.intrinsics.cy, 240);
    for (const char* wrong : {"1 SIMPLE_PINHOLE 640 480 500 500 320 240\n",
                              "1 SIMPLE_PINHOLE 640 480 500 320\n2 PINHOLE 640 480 500 500 320 240\n"}) {
        put("cameras.txt", wrong);
        expect_error(dir, "cameras.txt, line 1: expected 3 parameters of SIMPLE_PINHOLE, found ");
    }
}

TEST_F(CameraReaders, CamerasThatNoPhotoHasMayBeOfAnyModel) {
    put("images.txt", "1 1 0 0 0 0 0 0 1 a.jpg\n\n");
    put("cameras.txt", "2 EQUIRECTANGULAR 640 480\n1 PINHOLE 640 480 500 500 320 240\n");
    EXPECT_EQ(read_cameras(dir).entries.at(0).camera.intrinsics.cy, 240);
    put("cameras.txt", "# none\n1 EQUIRECTANGULAR 640 480\n");
    expect_error(dir, "cameras.txt, line 2: expected a COLMAP camera model, found 'EQUIRECTANGULAR'");
    const auto opensfm = [&](const std::string& camera) {
        return put(
            "reconstruction.json",
            "[{\"cameras\": {\"s\": {\"projection_type\": \"spherical\"}, "
            "\"p\": {\"projection_type\": \"perspective\", \"width\": 60, \"height\": 40, \"focal\": 0.5}}, "
            "\"shots\": {\"a.jpg\": {\"camera\": \"" +
                camera +
                "\", \"rotation\": [0, 0, 0], "
                "\"translation\": [0, 0, 0]}}}]");
    };
    EXPECT_EQ(read_cameras(opensfm("p")).entries.at(0).camera.intrinsics.fx, 30);
    expect_error(opensfm("s"), "projection_type: found \"spherical\", expected perspective, brown");
    const auto openmvg = [&](const char* key) {
        return put(
            "sfm_data.json",
            std::string(
                "{\"sfm_data_version\": \"0.3\", \"views\": [{\"value\": "
                "{\"ptr_wrapper\": {\"data\": {\"filename\": \"a.jpg\", \"id_pose\": 0, \"id_intrinsic\": ") +
                key +
                "}}}}], \"intrinsics\": [{\"key\": 0, \"value\": {\"polymorphic_id\": 2147483649, "
                "\"polymorphic_name\": \"spherical\"}}, {\"key\": 1, \"value\": {\"polymorphic_id\": "
                "2147483650, "
                "\"polymorphic_name\": \"pinhole\", \"ptr_wrapper\": {\"data\": {\"width\": 60, \"height\": "
                "40, "
                "\"focal_length\": 50, \"principal_point\": [30, 20]}}}}], \"extrinsics\": [{\"key\": 0, "
                "\"value\": "
                "{\"rotation\": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], \"center\": [0, 0, 0]}}]}");
    };
    EXPECT_EQ(read_cameras(openmvg("1")).entries.at(0).camera.intrinsics.fx, 50);
    expect_error(openmvg("0"), "not 'spherical'");
}

TEST_F(CameraReaders, FilesWithoutCamerasOfAllFormatsAreTold) {
    const std::string views = "\"views\": [{\"path\": \"a.jpg\", \"poseId\": 1, \"intrinsicId\": 2",
                      sfm = "{\"version\": [1, 2, 11], \"intrinsics\": [{\"intrinsicId\": 2}], " + views;
    put("list.txt", "a.jpg\n");
    struct Case {
        const char *file, *text, *words;
    };
    const std::string rig = sfm + ", \"rigId\": 1, \"subPoseId\": 0}]}", unposed = sfm + "}]}";
    const Case cases[] = {
        {"init.sfm", unposed.c_str(),
         "init.sfm: expected a camera with a pose, found none (a.jpg: skipped, no pose)"},
        {"rig.sfm", rig.c_str(), "rig.sfm: no camera can be used: a.jpg: skipped, part of a rig"},
        {"sfm_data.json",
         "{\"sfm_data_version\": \"0.3\", \"views\": [], \"intrinsics\": [], \"extrinsics\": []}",
         "expected a camera with a pose, found none"},
        {"topo.json", "[{\"cameras\": {\"c\": {\"projection_type\": \"brown\"}}, \"shots\": {}}]",
         "topo.json: expected a shot, found none"},
        {"base.json", "{\"frames\": [], \"transform_matrix\": 0}", "base.json: expected a frame, found none"},
        {"a.xml", "<BlocksExchange/>", "expected BlocksExchange with Photogroups, found none"},
        {"b.xml", "<BlocksExchange><Block><Photogroups/></Block></BlocksExchange>", "a camera with a pose"},
        {"c.csv", "#name,x,y,alt,heading,pitch,roll,f,px,py\n", "c.csv: expected a camera, found none"},
        {"d.xml", "<document><chunk></chunk></document>", "d.xml: expected a camera with a pose, found none"},
        {"e.xml", "<document><!-- <chunk > --></document>", "e.xml: expected cameras of Metashape"},
        {"f.out", "# Bundle file v0.3\n1 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n", "a focal length above 0"},
        {"g.rzml", "<RZML/>", "expected a SHOT with a CFRM"},
        {"images.txt", "# none\n", ": expected an image with a pose in images.txt, found none"}};
    put("cameras.txt", "1 SIMPLE_PINHOLE 640 480 500 320 240\n");
    for (const Case& c : cases) expect_error<NoCamera>(put(c.file, c.text), c.words);
    put("cameras.bin", std::string(8, '\0'));
    expect_error<NoCamera>(put("images.bin", std::string(8, '\0')),
                           ": expected an image with a pose in images.bin, found none");
}

TEST_F(CameraReaders, TableOfPositionsAloneIsNoTableOfCameras) {
    for (const char* header : {"name,x,y,z\n", "#name,x,y,alt\n", "name,x,y,z,note\nP1,1,2,3,heading\n"})
        EXPECT_FALSE(is_realitycapture_csv(put("points.csv", header))) << header;
    for (const char* header : {"#name,x,y,alt,heading,pitch,roll,f\r\n", "name, x, y, z, yaw, pitch, roll\n",
                               "#name,R00,R01,R02,R10,R11,R12,R20,R21,R22,tx,ty,tz", "#cameras 3\n",
                               "#name,x,y,alt,omega,phi,kappa\n"})
        EXPECT_TRUE(is_realitycapture_csv(put("cameras.csv", header))) << header;
}

TEST_F(CameraReaders, OutputOfOtherProgramsIsNotTakenForBundler) {
    put("list.txt", "");
    const auto matches = [&](const char* text) {
        const fs::path file = put("a.out", text);
        return std::ranges::any_of(camera_formats(), [&](const CameraFormat& f) { return f.matches(file); });
    };
    for (const char* text :
         {"", "running...\n", "# log\n", "2 photos\n1 2\n", "1.5 2\n", "1 2 3\n", "-1 2\n", "7\n2\n"})
        EXPECT_FALSE(matches(text)) << text;
    for (const char* text : {"# Bundle file v0.3\n1 0\n", "\n# a comment\n12 3400 \r\n500 0 0\n"})
        EXPECT_TRUE(matches(text)) << text;
    expect_error(put("nohup.out", "running...\n"), "expected the number of cameras, found 'running...'");
}

TEST_F(CameraReaders, TransformsTakeTheFocalLengthThatIsGiven) {
    const double right = std::numbers::pi / 2;  // the focal length is half the photo's side
    struct Case {
        std::string keys;
        CameraSet::Unit unit;
        Eigen::Vector4d focal_center;
    };
    using Unit = CameraSet::Unit;
    const std::string x = "\"camera_angle_x\": " + std::to_string(right), size = ", \"w\": 60, \"h\": 40",
                      y = "\"camera_angle_y\": " + std::to_string(right);
    const Case cases[] = {{"\"fl_x\": 50, \"fl_y\": 48, \"cx\": 31, \"cy\": 19, " + x,
                           Unit::pixels_from_corner,
                           {50, 48, 31, 19}},
                          {"\"fl_x\": 50, \"cx\": 31", Unit::pixels_from_center, {50, 50, 0, 0}},
                          {"\"fl_y\": 48", Unit::pixels_from_center, {48, 48, 0, 0}},
                          {"\"fl_x\": 0, \"cx\": 31, \"cy\": 19, " + x, Unit::photo_width, {0.5, 0.5, 0, 0}},
                          {"\"fl_y\": 48" + size, Unit::pixels, {48, 48, 30, 20}},
                          {"\"fl_x\": 0, \"fl_y\": 0, " + x + size, Unit::pixels, {30, 30, 30, 20}},
                          {y + size, Unit::pixels, {20, 20, 30, 20}},
                          {x + ", " + y + size, Unit::pixels, {30, 20, 30, 20}}};
    for (const Case& c : cases) {
        const CameraSet set = read_cameras(put_transforms(c.keys));
        const Intrinsics& k = set.entries.at(0).camera.intrinsics;
        EXPECT_EQ(set.entries[0].unit, c.unit) << c.keys;
        EXPECT_LT((Eigen::Vector4d(k.fx, k.fy, k.cx, k.cy) - c.focal_center).norm(), 1e-4) << c.keys;
    }
}

TEST_F(CameraReaders, FocalLengthThatCannotBeIsNamed) {
    expect_error(put_transforms("\"fl_x\": 0"), "fl_x: found 0, expected a focal length above 0");
    expect_error(put_transforms("\"fl_x\": -50, \"w\": 60, \"h\": 40"), "fl_x: found -50");
    expect_error(put_transforms("\"camera_angle_x\": 60"),
                 "camera_angle_x: found 60, expected an angle in radians, above 0 and below pi");
    expect_error(put_transforms("\"w\": 60"), "expected a focal length, fl_x or camera_angle_x");
}

}  // namespace
}  // namespace vantage
