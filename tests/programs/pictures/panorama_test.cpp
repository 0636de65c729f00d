// Panoramas.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <pugixml.hpp>

#include "base/text/error.h"
#include "player/render/picture.h"
#include "player/view/shots.h"
#include "tests/programs/garden_package.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

using std::numbers::pi;

class Panoramas : public GardenPackage {
  protected:
    void SetUp() override {
        GardenPackage::SetUp();
        make_package({{Effect::background, EffectChoice::off}});
    }
};

/// The color at a position, interpolated between four pixels, as 8-bit values.
Eigen::Vector3d color_at(const Picture& p, double x, double y) {
    const int left = std::clamp(int(std::floor(x - 0.5)), 0, p.width - 2),
              top = std::clamp(int(std::floor(y - 0.5)), 0, p.height - 2);
    const double u = std::clamp(x - 0.5 - left, 0.0, 1.0), v = std::clamp(y - 0.5 - top, 0.0, 1.0);
    const auto pixel = [&](int dx, int dy) {
        const auto i = std::size_t(4 * ((top + dy) * p.width + left + dx));
        return Eigen::Vector3d(p.rgba[i], p.rgba[i + 1], p.rgba[i + 2]);
    };
    return (1 - v) * ((1 - u) * pixel(0, 0) + u * pixel(1, 0)) +
           v * ((1 - u) * pixel(0, 1) + u * pixel(1, 1));
}

}  // namespace

TEST_F(Panoramas, ShowEachDirectionWhereAViewerLooksForIt) {
    // Views from one position in several directions. The panorama's center is +y, the direction of the first
    // view.
    const PackageReader package(file);
    const auto panorama = read_png(
        offscreen("around", "--view 4,-7,2,4,-3,2 --panorama --size 1024x512 --holes shade --samples 2"));
    ASSERT_EQ(panorama.width, 1024);
    for (const char* const to : {"4,-3,1.6", "6.5,-4,1.6", "8,-7.3,1.8", "1,-9.5,1.5", "4.1,-6.9,8"}) {
        const std::string text = std::string("4,-7,2,") + to + ",60";
        const Picture direct =
            read_png(offscreen("direct", "--view " + text + " --size 240x180 --holes shade --samples 2"));
        const View view = parse_view(text, package, {240, 180});
        const Intrinsics& k = view.intrinsics;
        // Means over blocks are compared, because the two pictures are sampled differently.
        constexpr int block = 4;
        double sum = 0;
        int counted = 0;
        for (int top = block; top < k.height - block; top += block)
            for (int left = block; left < k.width - block; left += block, ++counted) {
                Eigen::Vector3d off = Eigen::Vector3d::Zero();
                for (int row = top; row < top + block; ++row)
                    for (int column = left; column < left + block; ++column) {
                        const Eigen::Vector3d d =
                            view.cam_from_origin.R.transpose() *
                            Eigen::Vector3d((column + 0.5 - k.cx) / k.fx, (row + 0.5 - k.cy) / k.fy, 1);
                        const double longitude = std::atan2(d.x(), d.y()),
                                     latitude = std::atan2(d.z(), std::hypot(d.x(), d.y()));
                        off += color_at(panorama, (longitude / (2 * pi) + 0.5) * 1024,
                                        (0.5 - latitude / pi) * 512);
                        const auto i = std::size_t(4 * (row * k.width + column));
                        off -= Eigen::Vector3d(direct.rgba[i], direct.rgba[i + 1], direct.rgba[i + 2]);
                    }
                sum += (off / (block * block)).squaredNorm() / 3;
            }
        EXPECT_GT(10 * std::log10(255 * 255 * counted / sum), 33) << to << ": PSNR, dB";
    }
}

using PanoramasAtLength = Panoramas;
TEST_F(PanoramasAtLength, ShowToEachEyeWhatItSeesWhereItTurns) {
    // The eye separation is large, so that the eyes' pictures differ. For objects straight ahead, the eyes
    // are on opposite sides of the middle.
    const PackageReader package(file);
    constexpr double apart = 0.4;
    constexpr int w = 768, h = 384;
    const auto both =
        read_png(offscreen("both",
                           "--view 4,-7,2,4,-3,2 --panorama --stereo over-under --eye-separation "
                           "0.4 --size 768x384 --holes shade"));
    ASSERT_EQ(both.width, w);
    ASSERT_EQ(both.height, 2 * h);
    for (const Eigen::Vector2d& ahead : {Eigen::Vector2d(0, 1), {0.6, 0.8}, {-0.8, 0.6}}) {
        for (const int eye : {0, 1}) {
            const double side = (eye - 0.5) * apart;
            const Eigen::Vector2d at(4 + side * ahead.y(), -7 - side * ahead.x()), to = at + 4 * ahead;
            char text[200];
            std::snprintf(text, sizeof(text), "%.6f,%.6f,2,%.6f,%.6f,1.8,70", at.x(), at.y(), to.x(), to.y());
            const Picture direct = read_png(offscreen(
                "direct", std::string("--view ") + text + " --size 480x360 --holes shade --samples 2"));
            const View view = parse_view(text, package, {480, 360});
            const Intrinsics& k = view.intrinsics;
            // Blocks of 4 rows are compared, within 2 columns of the direction in which this eye looks
            // straight ahead.
            const double middle = (std::atan2(ahead.x(), ahead.y()) / (2 * pi) + 0.5) * w;
            std::array<double, 2> psnr{};
            for (const int half : {0, 1}) {
                double sum = 0;
                int counted = 0;
                for (int top = h / 2 - 52; top < h / 2 + 52; top += 4, ++counted) {
                    Eigen::Vector3d off = Eigen::Vector3d::Zero();
                    for (int y = top; y < top + 4; ++y)
                        for (int x = int(middle) - 2; x < int(middle) + 2; ++x) {
                            const double l = ((x + 0.5) / w - 0.5) * 2 * pi, b = (0.5 - (y + 0.5) / h) * pi;
                            const Eigen::Vector3d d = view.cam_from_origin.R *
                                                      Eigen::Vector3d(std::cos(b) * std::sin(l),
                                                                      std::cos(b) * std::cos(l), std::sin(b));
                            off += color_at(both, x + 0.5, half * h + y + 0.5) -
                                   color_at(direct, k.fx * d.x() / d.z() + k.cx, k.fy * d.y() / d.z() + k.cy);
                        }
                    sum += (off / 16).squaredNorm() / 3;
                }
                psnr[std::size_t(half)] = 10 * std::log10(255 * 255 * counted / sum);
            }
            EXPECT_GT(psnr[std::size_t(eye)], 30) << ahead.transpose() << ", eye " << eye;
            EXPECT_GT(psnr[std::size_t(eye)], psnr[std::size_t(1 - eye)] + 3)
                << "the picture should match its own eye better than the other eye";
        }
    }
}

TEST_F(Panoramas, SayWhatTheyAreToViewers) {
    const std::string bytes = slurp(offscreen("around", "--photo 0001 --panorama --size 256x128"));
    const std::size_t begin = bytes.find("<x:xmpmeta"), end = bytes.find("</x:xmpmeta>");
    ASSERT_NE(begin, std::string::npos);
    ASSERT_NE(end, std::string::npos);
    EXPECT_NE(bytes.find("iTXtXML:com.adobe.xmp"), std::string::npos);
    pugi::xml_document packet;
    ASSERT_TRUE(packet.load_string(bytes.substr(begin, end + 12 - begin).c_str()));
    const auto fields = packet.child("x:xmpmeta").child("rdf:RDF").child("rdf:Description");
    const auto field = [&](const char* name) { return std::string(fields.attribute(name).value()); };
    EXPECT_EQ(field("xmlns:GPano"), "http://ns.google.com/photos/1.0/panorama/");
    EXPECT_EQ(field("GPano:ProjectionType"), "equirectangular");
    EXPECT_EQ(field("GPano:FullPanoWidthPixels"), "256");
    EXPECT_EQ(field("GPano:FullPanoHeightPixels"), "128");
    EXPECT_EQ(field("GPano:CroppedAreaImageWidthPixels"), "256");
    EXPECT_EQ(field("GPano:CroppedAreaLeftPixels"), "0");
}

TEST_F(Panoramas, AreRefusedInOneLineIfTheyCannotBeMade) {
    const auto says = [&](const std::string& options) {
        const fs::path log = dir / "says.txt";
        const int status = std::system((VANTAGE_PLAYER " render " + file.string() + " --photo 0001 " +
                                        options + " -o " + (dir / "x.png").string() + " 2>" + log.string())
                                           .c_str());
        EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, int(Exit::usage)) << options;
        return slurp(log);
    };
    EXPECT_NE(says("--panorama --size 300x200").find("twice as wide as high"), std::string::npos);
    EXPECT_NE(says("--panorama --size 200000x100000").find("expected up to"), std::string::npos);
    EXPECT_NE(says("--panorama --stereo checkerboard").find("over-under"), std::string::npos);
    EXPECT_FALSE(fs::exists(dir / "x.png"));
}
