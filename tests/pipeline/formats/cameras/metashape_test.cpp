// Metashape's XML as it occurs in users' projects.
#include <gtest/gtest.h>

#include <fstream>

#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/input/discover.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

constexpr const char* calibrated =
    "<sensor id=\"0\" type=\"frame\"><resolution width=\"400\" height=\"300\"/>"
    "<calibration type=\"frame\" class=\"adjusted\"><resolution width=\"400\" height=\"300\"/>"
    "<f>350</f></calibration></sensor>";

std::string camera(const std::string& label, double x) {
    return "<camera id=\"0\" sensor_id=\"0\" label=\"" + label + "\"><transform>1 0 0 " + std::to_string(x) +
           " 0 1 0 0 0 0 1 0 0 0 0 1</transform></camera>";
}

class Metashape : public TemporaryFolder {
  protected:
    CameraSet cameras(const std::string& sensors, const std::string& cameras) const {
        std::ofstream(dir / "cameras.xml")
            << "<document version=\"2.0.0\"><chunk label=\"Chunk 1\" enabled=\"true\"><sensors>" << sensors
            << "</sensors><cameras>" << cameras << "</cameras></chunk></document>";
        return read_cameras(dir / "cameras.xml");
    }
    void expect_no_camera(const std::string& sensors, const std::string& in_chunk, const char* why) const {
        try {
            cameras(sensors, in_chunk);
            ADD_FAILURE() << "was accepted; expected: " << why;
        } catch (const NoCamera& e) {
            EXPECT_NE(std::string(e.what()).find(why), std::string::npos) << e.what();
        }
    }
    static std::vector<std::string> names(const CameraSet& set) {
        std::vector<std::string> out;
        for (const CameraSet::Entry& e : set.entries) out.push_back(e.group + ":" + e.photo);
        return out;
    }
};

TEST_F(Metashape, CamerasHaveTheirGroups) {
    const auto group = [](const char* label, const char* type, const std::string& content) {
        return std::string("<group label=\"") + label + "\" type=\"" + type + "\">" + content + "</group>";
    };
    const std::string all = group("left", "folder", camera("A", 0) + group("day", "folder", camera("A", 1))) +
                            group("right", "station", camera("A", 2)) + camera("B", 3);
    EXPECT_EQ(names(cameras(calibrated, all)),
              (std::vector<std::string>{"left:A", "left/day:A", "right:A", ":B"}));
}

TEST_F(Metashape, SensorWithoutCalibrationHasTheFocalLengthOfItsCamera) {
    const auto sensor = [](const char* properties) {
        return std::string("<sensor id=\"0\" type=\"frame\"><resolution width=\"400\" height=\"300\"/>") +
               properties + "<fixed>true</fixed></sensor>";
    };
    constexpr const char* all =
        "<property name=\"pixel_width\" value=\"0.01\"/><property name=\"pixel_height\" value=\"0.0125\"/>"
        "<property name=\"focal_length\" value=\"3.5\"/>";
    const Camera c = cameras(sensor(all), camera("A", 0)).entries.front().camera;
    EXPECT_DOUBLE_EQ(c.intrinsics.fx, 350);
    EXPECT_DOUBLE_EQ(c.intrinsics.fy, 280);
    EXPECT_DOUBLE_EQ(c.intrinsics.cx, 200);
    EXPECT_DOUBLE_EQ(c.intrinsics.cy, 150);
    EXPECT_FALSE(c.lens.distorts());
    constexpr const char* across =
        "<property name=\"pixel_width\" value=\"0.01\"/><property name=\"focal_length\" value=\"3.5\"/>"
        "<calibration type=\"frame\" class=\"initial\"><resolution width=\"400\" "
        "height=\"300\"/></calibration>";
    EXPECT_DOUBLE_EQ(cameras(sensor(across), camera("A", 0)).entries.front().camera.intrinsics.fy, 350)
        << "with square pixels and an empty calibration";
    expect_no_camera(sensor("<property name=\"focal_length\" value=\"3.5\"/>"), camera("A", 0),
                     "its sensor 0 has no calibrated focal length, and no property pixel_width");
    for (const char* lacks : {"", "<property name=\"focal_length\" value=\"3.5\"/>",
                              "<property name=\"pixel_width\" value=\"0\"/><property name=\"pixel_height\" "
                              "value=\"0.01\"/><property name=\"focal_length\" value=\"3.5\"/>"})
        EXPECT_THROW(cameras(sensor(lacks), camera("A", 0)), NoCamera) << lacks;
}

TEST_F(Metashape, SensorsThatNoPosedCameraHasAreNotRead) {
    const std::string bad = "<sensor id=\"1\"><calibration><f>x</f></calibration></sensor>";
    const std::string lost = "<camera id=\"1\" sensor_id=\"1\" label=\"lost\"/>";
    EXPECT_EQ(names(cameras(calibrated + bad, camera("A", 0) + lost)), std::vector<std::string>{":A"});
}

TEST_F(Metashape, SizeIsThatOfTheSensorIfTheCalibrationHasNone) {
    const std::string calibration = "<calibration><f>350</f></calibration>";
    std::string own = camera("A", 0);
    own.insert(own.find("<transform>"), calibration);
    EXPECT_EQ(cameras(calibrated, own).entries.at(0).camera.intrinsics.width, 400);
    try {
        cameras("<sensor id=\"0\">" + calibration + "</sensor>", camera("A", 0));
        ADD_FAILURE() << "accepted without a size";
    } catch (const Error& e) {
        EXPECT_TRUE(std::string(e.what()).ends_with(
            "line 1: <calibration>: expected a <resolution> here or in its sensor, found none"))
            << e.what();
    }
}

TEST_F(Metashape, LensOfAnotherTypeIsSkippedWhereverItIsSaid) {
    const std::string size = "<resolution width=\"400\" height=\"300\"/>",
                      fisheye =
                          "<calibration type=\"equisolid_fisheye\">" + size + "<f>350</f></calibration>";
    std::string own = camera("A", 0);
    own.insert(own.find("<transform>"), size + fisheye);
    expect_no_camera("<sensor id=\"0\">" + fisheye + "</sensor>", camera("A", 0),
                     "A: skipped, its sensor 0 has a lens of type 'equisolid_fisheye', expected 'frame'");
    expect_no_camera("<sensor id=\"0\" type=\"spherical\">" + size + "</sensor>", camera("A", 0),
                     "A: skipped, its sensor 0 has a lens of type 'spherical', expected 'frame'");
    expect_no_camera(calibrated, own, "A: skipped, its calibration has a lens of type 'equisolid_fisheye'");
}

TEST_F(Metashape, ExportOfMarkersIsNotTakenForCameras) {
    cameras(calibrated, camera("A", 0));
    std::filesystem::copy_file(dir / "cameras.xml", dir / "scan.xml");
    EXPECT_THROW(cameras(calibrated, "<camera id=\"0\" sensor_id=\"0\" label=\"A\"/>"), NoCamera);
    std::filesystem::rename(dir / "cameras.xml", dir / "markers.xml");
    const FoundInput found = search(dir, {});
    EXPECT_EQ(found.files.cameras.filename(), "scan.xml");
    ASSERT_EQ(found.files.notes.size(), 1u);
    EXPECT_TRUE(found.files.notes[0].starts_with("markers.xml: not used, ")) << found.files.notes[0];
}

TEST_F(Metashape, OtherXmlWithChunksIsNotTakenForCameras) {
    cameras(calibrated, camera("A", 0));
    const auto put = [&](const char* name, const char* text) { std::ofstream(dir / name) << text; };
    put("README.xml", "<readme>see <chunk</readme>");
    put("doc.xml", "<?xml version=\"1.0\"?><chunk version=\"1.2.0\"><sensors/></chunk>");
    put("project.xml", "<document version=\"1.2.0\"><chunks next_id=\"1\"/></document>");
    put("empty.xml", "<document><!-- <chunk > --></document>");
    EXPECT_EQ(search(dir, {}).files.cameras.filename(), "cameras.xml");
}

}  // namespace
}  // namespace vantage
