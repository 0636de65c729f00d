#pragma once
#include <gtest/gtest.h>

#include <fstream>

#include "base/files/png_file.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "tests/pipeline/formats/exported_cameras.h"
#include "tests/temporary_folder.h"

namespace vantage {

namespace fs = std::filesystem;

class CameraExports : public TemporaryFolder {
  protected:
    using Photo = exported::Photo;

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
    /// Reads the folder as prepare does and compares the cameras with the ground truth.
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
    /// OpenCV's equations, implemented independently.
    static Eigen::Vector2d distorted(const Photo& p, const Eigen::Vector2d& q) {
        const double x = q.x(), y = q.y(), r2 = x * x + y * y,
                     radial = 1 + p.k1 * r2 + p.k2 * r2 * r2 + p.k3 * r2 * r2 * r2;
        return {x * radial + 2 * p.p1 * x * y + p.p2 * (r2 + 2 * x * x),
                y * radial + p.p1 * (r2 + 2 * y * y) + 2 * p.p2 * x * y};
    }
};

}  // namespace vantage
