// Reads the same cameras from the export formats of other programs.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <random>

#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "tests/pipeline/formats/exported_cameras.h"
#include "tests/pipeline/formats/exported_scan.h"

namespace vantage {

namespace {

using exported::Photo;

Eigen::Matrix3d random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
}

/// Cameras that look in all directions, each with its own lens; two of them are in portrait format.
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

/// Photos with the same focal length in x and y.
std::vector<Photo> with_square_pixels(std::vector<Photo> photos) {
    for (Photo& p : photos) p.fy = p.fx;
    return photos;
}

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
            ADD_FAILURE() << c.file << " was accepted; expected: " << c.expected;
        } catch (const Error& e) {
            const std::string what = e.what();
            EXPECT_NE(what.find(c.expected), what.npos) << what;
            EXPECT_EQ(what.find('\n'), what.npos) << what;
            EXPECT_NE(what.find(c.file), what.npos) << what;
        }
    }
}

}  // namespace vantage
