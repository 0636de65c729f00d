// Compares the output of vantage-player orthophoto with parallel rays cast through a synthetic scene.
#include "player/pictures/orthophoto.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "base/gl/context.h"
#include "base/values/srgb.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using Eigen::Vector3d;
namespace fs = std::filesystem;

namespace {

SynthSpec spec() {
    SynthSpec s = spec_named("tiny");
    s.photos.width = 700;
    s.photos.height = 525;
    s.photos.samples = 2;
    return s;
}

/// The scene's geometry and light, without cameras.
struct Truth {
    SynthModel model = build_model(spec());
    RayScene rays{model.mesh};

    struct Seen {
        Vector3d normal;
        Eigen::Vector3f light;  ///< linear
    };
    /// The first surface in a direction, if there is one, lit by the sun and the sky as in the photos.
    std::optional<Seen> at(const Vector3d& from, const Vector3d& ahead) const {
        const auto hit = rays.first_hit(from, ahead);
        if (!hit) return {};
        const auto& t = model.mesh.triangles[hit->triangle];
        const auto corner = [&](std::size_t i) { return model.mesh.normals[t[i]].cast<double>(); };
        const Vector3d n =
            (corner(0) * (1 - hit->uv.sum()) + corner(1) * hit->uv.x() + corner(2) * hit->uv.y())
                .normalized();
        const Vector3d p = from + hit->distance * ahead, sun = Vector3d(-0.55, -0.75, 0.62).normalized();
        const double facing = n.dot(sun);
        const bool lit = facing > 0 && !rays.occluded(p + n * 2e-3, sun, 0, 1e6);
        const double light = 0.34 * (0.65 + 0.35 * n.z()) + (lit ? 0.85 * facing : 0.0);
        return Seen{n, albedo(model.materials[hit->triangle], p, n) * float(light)};
    }
};

/// The front view of the facade: 8 m wide, 6 m high, at 25 mm per pixel.
constexpr double resolution = 0.025;
constexpr int width = 320, height = 240;
Vector3d front(double column, double row) { return {-4 + column * resolution, -20, 6 - row * resolution}; }

class OrthophotoProgram : public TemporaryFolder {
  protected:
    static inline fs::path collection;
    static fs::path package() { return collection / "scene.vantage"; }
    static void SetUpTestSuite() {
        collection = fs::temp_directory_path() / ("vantage-orthophoto-" + std::to_string(::getpid()));
        copy_scene(spec(), collection / "scene");
        copy_package(collection / "scene", {}, package());
    }
    static void TearDownTestSuite() { fs::remove_all(collection); }

    int run(const std::string& options) const {
        const std::string command = std::string(VANTAGE_PLAYER " orthophoto ") + package().string() + " -q " +
                                    options + " 2>" + (dir / "says").string();
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string says() const { return slurp(dir / "says"); }
    Picture picture(const std::string& options) const {
        const fs::path file = dir / "o.png";
        EXPECT_EQ(run(options + " --force -o " + file.string()), 0) << says();
        return read_png(file);
    }
    static std::array<int, 4> pixel(const Picture& p, int x, int y) {
        const auto at = 4 * (std::size_t(y) * std::size_t(p.width) + std::size_t(x));
        return {p.rgba[at], p.rgba[at + 1], p.rgba[at + 2], p.rgba[at + 3]};
    }
};

}  // namespace

TEST_F(OrthophotoProgram, ShowsTheSurfaceWhereRaysAtRightAnglesMeetIt) {
    const Picture p =
        picture("--plane front --resolution 0.025 --extent -4,0,4,6 --samples 1 --light normals");
    ASSERT_EQ(p.width, width);
    ASSERT_EQ(p.height, height);
    const Truth truth;
    int compared = 0, wrong = 0;
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            const auto at = [&](int dx, int dy) {
                return truth.at(front(x + 0.5 + dx, y + 0.5 + dy), Vector3d::UnitY());
            };
            const auto here = at(0, 0);
            ASSERT_TRUE(here) << "the facade should fill the picture";
            const auto is_like = [&](int dx, int dy) { return at(dx, dy)->normal.dot(here->normal) > 0.99; };
            if (!is_like(1, 0) || !is_like(-1, 0) || !is_like(0, 1) || !is_like(0, -1))
                continue;  // an edge within a pixel
            ++compared;
            Vector3d n = here->normal;
            if (n.y() > 0) n = -n;
            const std::array<double, 3> code{n.x() / 2 + 0.5, n.z() / 2 + 0.5, -n.y() / 2 + 0.5};
            const auto shown = pixel(p, x, y);
            for (std::size_t c = 0; c < 3; ++c)
                if (std::abs(shown[c] - 255 * code[c]) > 12) {
                    ++wrong;
                    break;
                }
        }
    EXPECT_GT(compared, 60000);
    EXPECT_LE(wrong, compared / 1000);
}

TEST_F(OrthophotoProgram, HasTheColorsOfTheSceneInTheirPlace) {
    const Picture p = picture("--plane front --resolution 0.025 --extent -4,0,4,6");
    const Truth truth;
    std::vector<double> expected(std::size_t(width) * height), shown(expected.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double green = 0;
            for (int s = 0; s < 4; ++s)
                green +=
                    double(truth.at(front(x + 0.25 + s % 2 * 0.5, y + 0.25 + s / 2 * 0.5), Vector3d::UnitY())
                               ->light[1]) /
                    4;
            expected[std::size_t(y * width + x)] = 255 * srgb_from_linear(green);
            shown[std::size_t(y * width + x)] = pixel(p, x, y)[1];
        }
    // Compare the whole picture where photos show it. Then compare parts of it: they must not match better
    // when they are shifted.
    double squares = 0;
    int colored = 0;
    const auto is_colored = [&](int x, int y) { return pixel(p, x, y)[3] == 255; };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (is_colored(x, y)) {
                ++colored;
                squares +=
                    std::pow(expected[std::size_t(y * width + x)] - shown[std::size_t(y * width + x)], 2);
            }
    EXPECT_GT(colored, width * height * 8 / 10);
    EXPECT_GT(10 * std::log10(255 * 255 / (squares / colored)), 20);
    int parts = 0, in_place = 0;
    constexpr int side = 32, reach = 3;
    for (int top = reach; top + side + reach <= height; top += side)
        for (int left = reach; left + side + reach <= width; left += side) {
            const auto off = [&](int dx, int dy) {
                double sum = 0;
                for (int y = top; y < top + side; ++y)
                    for (int x = left; x < left + side; ++x)
                        sum += std::pow(expected[std::size_t(y * width + x)] -
                                            shown[std::size_t((y + dy) * width + x + dx)],
                                        2);
                return sum / (side * side);
            };
            bool whole = true;
            for (int y = top - reach; y < top + side + reach; ++y)
                for (int x = left - reach; x < left + side + reach; ++x) whole &= is_colored(x, y);
            const double here = off(0, 0);
            double best = here, worst = here;
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    best = std::min(best, off(dx, dy)), worst = std::max(worst, off(dx, dy));
            if (!whole || worst < 4 * best || worst < 60) continue;  // too uniform to locate
            ++parts;
            in_place += here == best;
        }
    EXPECT_GT(parts, 15);
    EXPECT_GE(in_place, parts * 9 / 10) << parts;
}

TEST_F(OrthophotoProgram, IsTheSameHoweverItIsTiled) {
    const PackageReader reader(package());
    const gl::HeadlessContext context;
    Renderer renderer(reader, {});
    RenderSettings settings;
    settings.background = ShowBackground::off;
    const Orthophoto o =
        orthophoto_of(parse_plane("front", Vector3d::UnitZ()), parse_extent("-4.5,0,4.5,7"), 0.02);
    std::vector<std::uint32_t> photos(reader.photos().size());
    std::iota(photos.begin(), photos.end(), 0u);
    const auto drawn = [&](TileSize tile) {
        std::vector<std::uint8_t> out;
        std::size_t done = 0, all = 0;
        draw_orthophoto(
            renderer, o, {settings, photos, 2}, tile,
            [&](std::span<const std::uint8_t> row) { out.insert(out.end(), row.begin(), row.end()); },
            [&](std::size_t d, std::size_t a) {
                EXPECT_EQ(d, ++done);
                all = a;
            });
        EXPECT_EQ(done, all);
        EXPECT_EQ(out.size(), 4 * std::size_t(o.width) * std::size_t(o.height));
        return out;
    };
    const std::vector<std::uint8_t> whole = drawn({1024, 1024}), tiled = drawn({94, 62});
    std::size_t differ = 0, much = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const int by = std::abs(int(whole[i]) - int(tiled[i]));
        differ += by > 0, much += by > 1;
    }
    EXPECT_EQ(much, 0u);
    EXPECT_LE(differ, whole.size() / 1000) << "of " << whole.size();
}

TEST_F(OrthophotoProgram, WritesWhereItIs) {
    const Picture p = picture("--resolution 0.1");
    // The ground is 16 m wide and 8 m deep in front of the building, whose eaves extend 4.4 m behind its
    // front.
    EXPECT_EQ(p.width, 160);
    std::istringstream world(slurp(dir / "o.pgw"));
    std::vector<double> v;
    for (double x; world >> x;) v.push_back(x);
    ASSERT_EQ(v.size(), 6u);
    EXPECT_EQ(v[0], 0.1);
    EXPECT_EQ(v[3], -0.1);
    EXPECT_NEAR(v[4], -8 + 0.05, 1e-5);
    EXPECT_NEAR(v[5], 4.4 - 0.05, 1e-5);
    EXPECT_EQ(pixel(p, 2, 2)[3], 0) << "the picture should be empty next to the building's back";
}

TEST_F(OrthophotoProgram, AsGeoTiffIsTheSamePictureAndTellsItsPlace) {
    const Picture expected = picture("--resolution 0.1");
    const fs::path file = dir / "o.tif";
    ASSERT_EQ(run("--resolution 0.1 -o " + file.string()), 0) << says();
    EXPECT_FALSE(fs::exists(dir / "o.tfw"));
    TIFFSetWarningHandler(nullptr);  // libtiff does not know GeoTIFF's tags
    const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(file.c_str(), "r"), TIFFClose);
    ASSERT_TRUE(tiff);
    std::uint32_t w = 0, h = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &w);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &h);
    ASSERT_EQ(int(w), expected.width);
    ASSERT_EQ(int(h), expected.height);
    std::vector<std::uint8_t> row(4 * std::size_t(w));
    for (std::uint32_t y = 0; y < h; ++y) {
        ASSERT_EQ(TIFFReadScanline(tiff.get(), row.data(), y), 1);
        ASSERT_TRUE(std::equal(row.begin(), row.end(),
                               expected.rgba.begin() + std::ptrdiff_t(y) * std::ptrdiff_t(row.size())))
            << y;
    }
    const auto numbers = [&](std::uint32_t tag) {
        std::uint32_t count = 0;
        const double* values = nullptr;
        TIFFGetField(tiff.get(), tag, &count, &values);
        return std::vector<double>(values, values + (values ? count : 0));
    };
    EXPECT_EQ(numbers(33550), (std::vector<double>{0.1, 0.1, 0})) << "the tag for the size of a pixel";
    const std::vector<double> tie = numbers(33922);  // column and row of a point, and its position
    ASSERT_EQ(tie.size(), 6u);
    EXPECT_EQ(tie[0], 0);
    EXPECT_EQ(tie[1], 0);
    EXPECT_NEAR(tie[3], -8, 1e-5);
    EXPECT_NEAR(tie[4], 4.4, 1e-5);
    EXPECT_NE(run("--resolution 0.1 -o /proc/x.tif"), 0);
    EXPECT_EQ(std::ranges::count(says(), '\n'), 1) << says();
}

TEST_F(OrthophotoProgram, LeavesOutWhatPlanesCutAway) {
    const std::string all = "--plane front --resolution 0.1 --extent -4,0,4,6 --holes shade";
    const Picture whole = picture(all), part = picture(all + " --cut -1,0,2,0,0,2 --cut=-2,0,0,-1,0,0");
    for (int y = 0; y < whole.height; ++y)
        for (int x = 0; x < whole.width; ++x) {
            const bool removed = y < 40 || x < 20;
            if (y == 39 || y == 40 || x == 19 || x == 20) continue;  // at the planes
            ASSERT_EQ(pixel(whole, x, y)[3], 255);
            ASSERT_EQ(pixel(part, x, y)[3], removed ? 0 : 255) << x << " " << y;
        }
}

TEST_F(OrthophotoProgram, RefusesWhatCannotBeInOneLine) {
    const auto refuses = [&](const std::string& options, int code) {
        EXPECT_EQ(run(options), code) << options;
        EXPECT_EQ(std::ranges::count(says(), '\n'), 1) << options << ": " << says();
    };
    const std::string to = " -o " + (dir / "x.png").string();
    refuses("--plane north --resolution 0.1" + to, 2);
    refuses("--extent 3,0,1,1 --resolution 0.1" + to, 2);
    refuses("--resolution 1e-9" + to, 2);
    refuses("--resolution 0.1 --cut 0,0,1" + to, 2);
    refuses("--resolution 0.1 -o " + (dir / "x.jpg").string(), 2);
    refuses("--resolution 0.1 -o " + (dir / "missing").string() + "/.png", 2);
    std::ofstream(dir / "x.pgw") << "my notes\n";
    refuses("--resolution 0.1" + to, 2);
    EXPECT_EQ(slurp(dir / "x.pgw"), "my notes\n");
    EXPECT_FALSE(fs::exists(dir / "x.png"));
    EXPECT_NE(run(to), 0) << "a resolution is required";
}
