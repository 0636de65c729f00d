// Tests the preparation report as a reader sees it: extracts its pictures and legends from the page.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "pipeline/formats/export_colmap.h"
#include "pipeline/formats/export_ply.h"
#include "pipeline/photos/image_files.h"
#include "scene/camera/camera.h"
#include "tests/programs/patterns.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;
using Eigen::Matrix3d, Eigen::Vector3d, Eigen::Vector3f;
using Rgb = std::array<int, 3>;

namespace {

constexpr int side = 200;  ///< of a photo, px

/// A camera with a field of view of 53 degrees.
Camera look(const Vector3d& eye, const Vector3d& target, const Vector3d& up) {
    Camera c;
    c.intrinsics = {side, side, side, side, side / 2.0, side / 2.0};
    const Vector3d z = (target - eye).normalized(), x = z.cross(up).normalized();
    c.cam_from_world.R << x.transpose(), z.cross(x).transpose(), z.transpose();
    c.cam_from_world.t = -c.cam_from_world.R * eye;
    return c;
}

/// Decodes standard base64.
std::string decoded(std::string_view text) {
    const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | unsigned(digits.find(c));
        count += 6;
        if (count >= 8) out += char(bits >> (count -= 8) & 255);
    }
    return out;
}

class Report : public TemporaryFolder {
  protected:
    std::vector<NamedCamera> cameras;

    /// Prepares a wall in the world's plane y = 0, with gray photos of the wall from `cameras`. The world is
    /// rotated by `R`. The photo `passer_by` has a red object in its middle.
    void prepare(const Matrix3d& R, const std::vector<Vector3f>& corners, const std::string& passer_by = "",
                 const std::string& options = "") const {
        fs::create_directories(dir / "scan" / "images");
        std::vector<NamedCamera> turned = cameras;
        for (NamedCamera& c : turned) {
            c.camera.cam_from_world.R *= R.transpose();
            std::vector<std::uint8_t> rgb(std::size_t(3 * side * side), 150);
            for (int y = 80; c.photo == passer_by && y < 120; ++y)
                for (int x = 80; x < 120; ++x) rgb[std::size_t(3 * (y * side + x)) + 1] = 0;
            image_files().write(dir / "scan" / "images" / c.photo, side, side, 3, Sample::u8,
                                std::as_bytes(std::span(rgb)));
        }
        write_colmap_text(dir / "scan" / "sparse", turned);
        std::vector<Vector3f> positions, normals;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (const Vector3f& c : corners) positions.push_back(R.cast<float>() * c);
        normals.assign(corners.size(), R.cast<float>() * Vector3f(0, -1, 0));
        for (std::uint32_t i = 2; i < corners.size(); ++i) triangles.push_back({0, i - 1, i});
        write_ply(dir / "scan" / "mesh.ply",
                  {.positions = positions, .normals = normals, .triangles = triangles});
        const std::string command = VANTAGE_PROGRAM " prepare " + (dir / "scan").string() + " -o " +
                                    (dir / "scan.vantage").string() + " --refine off " + options + " >" +
                                    (dir / "says").string() + " 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << slurp(dir / "says");
    }
    std::string page() const { return slurp(dir / "scan.html"); }
    /// The picture in the page that has this description.
    RgbaImage picture(const std::string& description) const {
        const std::string html = page(), mark = "alt=\"" + description + "\" src=\"data:image/jpeg;base64,";
        const std::size_t at = html.find(mark);
        EXPECT_NE(at, html.npos) << description;
        const std::size_t begin = at + mark.size(), end = html.find('"', begin);
        const fs::path file = dir / "picture.jpg";
        std::ofstream(file, std::ios::binary) << decoded(std::string_view(html).substr(begin, end - begin));
        return image_files().read(file);
    }
    /// The names and colors of a legend's entries.
    std::map<std::string, Rgb> legend() const {
        constexpr const char* entry =
            R"x(<i style="background:rgb\((\d+),(\d+),(\d+)\)"></i><b>([a-z ]+)</b>)x";
        std::map<std::string, Rgb> out;
        for (const auto& m : matches(page(), entry))
            out[m[4]] = {std::stoi(m[1]), std::stoi(m[2]), std::stoi(m[3])};
        return out;
    }
};
class ReportAtLength : public Report {};

Rgb at(const RgbaImage& p, double x, double y) {
    const std::size_t i = 4 * (std::size_t(y * p.height) * std::size_t(p.width) + std::size_t(x * p.width));
    return {p.rgba[i], p.rgba[i + 1], p.rgba[i + 2]};
}

/// The legend's entry for a color or for a tint of that color.
std::string meaning(const Rgb& color, const std::map<std::string, Rgb>& legend) {
    const Vector3d white = Vector3d::Constant(255), off = Vector3d(color[0], color[1], color[2]) - white;
    if (off.norm() < 25) return "full weight";
    std::string best;
    double least = 1e9;
    for (const auto& [name, c] : legend) {
        const Vector3d ink = Vector3d(c[0], c[1], c[2]) - white;
        if (ink.norm() < 1) continue;
        const double share = std::clamp(off.dot(ink) / ink.squaredNorm(), 0.0, 1.0);
        if (const double far = (share * ink - off).norm(); far < least) least = far, best = name;
    }
    return best;
}

const std::vector<Vector3f> wall{{-3, 0, -3}, {3, 0, -3}, {3, 0, 3}, {-3, 0, 3}};
const Vector3d up = Vector3d::UnitZ();

/// The fraction of non-white pixels in a part of the picture. The part is given as fractions of the picture's
/// size.
double covered(const RgbaImage& p, double x0, double y0, double x1, double y1) {
    int all = 0, dark = 0;
    for (int y = int(y0 * p.height); y < int(y1 * p.height); ++y)
        for (int x = int(x0 * p.width); x < int(x1 * p.width); ++x, ++all)
            dark += p.rgba[std::size_t(4 * (y * p.width + x)) + 2] < 220;
    return double(dark) / std::max(1, all);
}

}  // namespace

TEST_F(Report, LegendOfWeightsIsThatOfThePictures) {
    cameras = {{"front.png", look({0, -4, 0}, {0, 0, 0}, up)},
               {"far.png", look({0, -20, 0}, {0, 0, 0}, up)},
               {"slanted.png", look({-12, -3, 0}, {0, 0, 0}, up)}};
    prepare(Matrix3d::Identity(), wall);
    const auto names = legend();
    ASSERT_EQ(names.size(), 6u);
    const RgbaImage front = picture("weight of front.png"), far = picture("weight of far.png"),
                    slanted = picture("weight of slanted.png");
    EXPECT_EQ(meaning(at(front, 0.5, 0.5), names), "full weight");
    EXPECT_EQ(meaning(at(front, 0.5, 0.005), names), "near an edge");
    EXPECT_EQ(meaning(at(front, 0.995, 0.5), names), "near an edge");
    EXPECT_EQ(meaning(at(far, 0.5, 0.5), names), "from afar");
    EXPECT_EQ(meaning(at(far, 0.1, 0.1), names), "nothing seen");
    EXPECT_EQ(meaning(at(slanted, 0.5, 0.5), names), "at a slant");
}

TEST_F(Report, ContradictedPartsHaveTheirColor) {
    for (int i = 0; i < 5; ++i)
        cameras.push_back(
            {std::to_string(i) + ".png", look({0.4 * (i - 2), -4, 0}, {0.4 * (i - 2), 0, 0}, up)});
    prepare(Matrix3d::Identity(), wall, "2.png", "--effect transients=on");
    EXPECT_EQ(meaning(at(picture("weight of 2.png"), 0.5, 0.5), legend()), "contradicted");
    EXPECT_EQ(meaning(at(picture("weight of 2.png"), 0.2, 0.2), legend()), "full weight");
    EXPECT_EQ(meaning(at(picture("weight of 1.png"), 0.5, 0.5), legend()), "full weight");
}

TEST_F(ReportAtLength, ModelStandsUprightWhateverAxisIsUp) {
    // A gable that is lower on its right side as seen from the cameras.
    const std::vector<Vector3f> gable{{-2, 0, -2}, {2, 0, -2}, {-2, 0, 2}};
    for (int i = -1; i <= 1; ++i)
        cameras.push_back({std::to_string(i + 1) + ".png", look({2.0 * i, -8, 1}, {0, 0, 0}, up)});
    Matrix3d z_down, y_down, x_up;
    z_down = Vector3d(1, -1, -1).asDiagonal();
    y_down << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    x_up << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    struct World {
        Matrix3d R;
        std::string front, back, above;
    };
    for (const World& w :
         {World{Matrix3d::Identity(), "-y", "+y", "above (+z)"}, World{z_down, "+y", "-y", "above (-z)"},
          World{y_down, "-z", "+z", "above (-y)"}, World{x_up, "-y", "+y", "above (+x)"}}) {
        fs::remove_all(dir / "scan");
        fs::remove(dir / "scan.vantage");
        prepare(w.R, gable);
        const RgbaImage front = picture("the model from " + w.front),
                        back = picture("the model from " + w.back);
        EXPECT_GT(covered(front, 0.05, 0.5, 0.5, 0.95), 0.9) << w.above;
        EXPECT_LT(covered(front, 0.5, 0.05, 0.95, 0.5), 0.1) << w.above;
        EXPECT_GT(covered(back, 0.5, 0.5, 0.95, 0.95), 0.9) << w.above << ": mirrored";
        EXPECT_LT(covered(back, 0.05, 0.05, 0.5, 0.5), 0.1) << w.above;
        EXPECT_NE(page().find("<figcaption>from " + w.above), std::string::npos) << w.above;
    }
}

TEST_F(Report, OfCamerasThatLookStraightDownIsSeenWithItsUpperSideAbove) {
    const std::vector<Vector3f> floor{{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}};
    for (int i = 0; i < 4; ++i)  // flown in parallel and crossing lines
        cameras.push_back(
            {std::to_string(i) + ".png",
             look({0.5 * i, 0, 6}, {0.5 * i, 0, 0}, Eigen::AngleAxisd(i * 1.5708, up) * Vector3d::UnitY())});
    prepare(Matrix3d::Identity(), floor);
    EXPECT_NE(page().find("<figcaption>from above (+z)"), std::string::npos);
}

TEST_F(Report, EveryColumnWithAFigureIsExplained) {
    cameras = {{"front.png", look({0, -4, 0}, {0, 0, 0}, up)}, {"far.png", look({0, -20, 0}, {0, 0, 0}, up)}};
    prepare(Matrix3d::Identity(), wall);
    const std::string html = page();
    EXPECT_EQ(html.find("<th class=n>"), html.npos);
    EXPECT_NE(html.find("<th class=n title="), html.npos);
}
