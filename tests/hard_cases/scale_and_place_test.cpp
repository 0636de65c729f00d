// Tests that a scene gives the same weight maps, coordinates and pictures if it is in other units, rotated or
// far from the origin.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "base/gl/context.h"
#include "base/values/tiling.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/subdivide.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "pipeline/reports/page/coverage_pictures.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/until_stopped.h"
#include "player/render/picture.h"
#include "scene/agreement/read_level.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using package::Type;

namespace {

/// x' = scale * turn * x + move.
struct OtherFrame {
    double scale = 1;
    Eigen::Vector3d move = Eigen::Vector3d::Zero();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();

    /// The camera that sees each moved point as `pose` sees the original point.
    Pose moved(const Pose& pose) const {
        const Eigen::Matrix3d R = pose.R * turn.transpose();
        return {R, scale * pose.t - R * move};
    }
    SceneInput moved(SceneInput scene) const {
        for (Eigen::Vector3d& p : scene.mesh.positions) p = (scale * (turn * p) + move).eval();
        for (Eigen::Vector3f& n : scene.mesh.normals)
            n = (turn * n.cast<double>()).normalized().cast<float>();
        for (PhotoInput& photo : scene.photos)
            photo.camera.cam_from_world = moved(photo.camera.cam_from_world);
        return scene;
    }
};

/// A package that is open in the player.
struct Opened {
    PackageReader package;
    Renderer renderer;
    std::vector<std::uint32_t> photos;

    explicit Opened(const std::filesystem::path& file) : package(file), renderer(package, {}) {
        photos.resize(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
    }
    Eigen::Vector3d origin() const { return Eigen::Map<const Eigen::Vector3d>(package.scene().origin); }
    Picture picture(const View& view, Blend blend) {
        RenderSettings s;
        s.blend = blend;
        // Background depths are discrete, and rounding decides between equally good depths.
        s.background = ShowBackground::off;
        return take_picture(renderer, view, s, photos, 1);
    }
    /// The numbers of the input vertices of all triangles, in package order.
    std::vector<float> order() const {
        const auto number = package.records<float>(Type::scalars);
        std::vector<float> out;
        for (const std::uint32_t v : package.records<std::uint32_t>(Type::indices)) out.push_back(number[v]);
        return out;
    }
    /// A photo's texture coordinates, in the order of the input's vertices.
    std::vector<Eigen::Vector2f> coordinates(std::uint32_t photo) const {
        const auto uv = package.records<Eigen::Vector2f>(Type::coordinates, photo);
        const auto number = package.records<float>(Type::scalars);
        std::vector<Eigen::Vector2f> out(uv.size());
        for (std::size_t v = 0; v < uv.size(); ++v) out[std::size_t(number[v])] = uv[v];
        return out;
    }
    /// The texels of one level of a photo.
    std::vector<std::uint8_t> texels(Type type, std::uint32_t photo, int level) const {
        const auto texels = read_level(package, package.photos()[photo], photo, type, level);
        std::vector<std::uint8_t> out(texels.size());
        std::memcpy(out.data(), texels.data(), out.size());
        return out;
    }
};

class ScaleAndPlace : public TemporaryFolder {
  protected:
    const gl::HeadlessContext context{gl::Debug::on};
    SceneInput scene;
    std::unique_ptr<Opened> given;

    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        spec.photos.count = 3;
        spec.photos.arc = 50;
        spec.photos.samples = 2;
        copy_scene(spec, dir / "scene");
        scene = read_scene(discover(dir / "scene"));
        subdivide_large_triangles(
            scene.mesh, main_box(scene.mesh));  // so that prepare adds no vertices and keeps their numbers
        VertexField number{"number", {}};
        for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) number.values.push_back(float(v));
        scene.mesh.scalars.push_back(number);
        given = opened(OtherFrame{}, "given");
    }
    std::unique_ptr<Opened> opened(const OtherFrame& by, const char* name) const {
        return opened(by.moved(scene), name);
    }
    std::unique_ptr<Opened> opened(const SceneInput& input, const char* name) const {
        const std::filesystem::path file = dir / name;
        PrepareSettings settings;  // for these photos, rounding decides whether gains are enabled
        settings.effects = {{Effect::exposure, EffectChoice::off}, {Effect::vignetting, EffectChoice::off}};
        settings.vertex_coordinates = true;
        prepare(input, settings, file, [](const Progress&) {});
        for (const Issue& i : check_package(file, {.deep = true})) ADD_FAILURE() << name << ": " << i.text;
        return std::make_unique<Opened>(file);
    }

    void expect_same_coordinates(const Opened& other) const {
        std::size_t flipped = 0, all = 0;
        for (const std::uint32_t photo : given->photos) {
            const package::PhotoRecord& record = given->package.photos()[photo];
            const Eigen::Vector2f size(float(record.width), float(record.height));
            const auto a = given->coordinates(photo), b = other.coordinates(photo);
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t v = 0; v < a.size(); ++v, ++all)
                if ((a[v].x() < 0) != (b[v].x() < 0)) {
                    ++flipped;
                } else if (a[v].x() >= 0) {
                    ASSERT_LT((a[v] - b[v]).cwiseProduct(size).norm(), 0.05f)
                        << "photo " << photo << " vertex " << v;
                }
            const package::PhotoRecord& theirs = other.package.photos()[photo];
            EXPECT_NEAR(record.hull_area, theirs.hull_area, 1e-4);
        }
        EXPECT_LE(double(flipped), 1e-4 * double(all))
            << "vertices that are visible in only one of the two packages";
    }

    /// Angle and border weights agree; depth and the density in the depth weight agree after scaling. Corners
    /// snap to 1/256 px, so rounding may assign a texel at an edge to the other surface.
    void expect_same_weight_maps(const Opened& other, double scale) const {
        const double reference = given->package.scene().reference_density,
                     theirs = other.package.scene().reference_density * scale;
        std::size_t differ = 0, all = 0;
        for (const std::uint32_t photo : given->photos) {
            const auto a = given->texels(Type::weight_maps, photo, weight_map_level),
                       b = other.texels(Type::weight_maps, photo, weight_map_level);
            const auto z = given->texels(Type::depth, photo, weight_map_level),
                       far = other.texels(Type::depth, photo, weight_map_level);
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t t = 0; t < a.size(); t += 4, ++all) {
                bool same = a[t + 3] == b[t + 3];
                if (a[t + 3] && b[t + 3]) {
                    float depth, theirs_depth;
                    std::memcpy(&depth, &z[t], 4);
                    std::memcpy(&theirs_depth, &far[t], 4);
                    same =
                        same && std::abs(double(theirs_depth) / scale - double(depth)) < 1e-3 * double(depth);
                    const double code = a[t + 1] + 12 * std::log2(reference / theirs);
                    same = same && std::abs(a[t] - b[t]) <= 1 && std::abs(a[t + 2] - b[t + 2]) <= 1 &&
                           std::abs(code - b[t + 1]) <= 1;
                }
                differ += !same;
            }
        }
        EXPECT_LE(double(differ), 1e-4 * double(all)) << "texels";
    }

    /// Expects that no byte differs by more than 2. If the order of triangles differs, a few pixels are
    /// excluded: those where an edge snaps to the other side of the pixel center.
    void expect_same_pictures(Opened& other, const OtherFrame& by) const {
        const double most = given->order() == other.order() ? 0 : 1e-4;
        const Eigen::Vector3d origin = given->origin();
        const View views[] = {view_of_photo(given->package.photos()[1], 1),
                              view_towards(Eigen::Vector3d(1.5, -7.5, 3.1) - origin,
                                           Eigen::Vector3d(-0.3, 0, 2.2) - origin, {0, 0, 1}, 50, 331, 250)};
        for (std::size_t i = 0; i < std::size(views); ++i) {
            View view = views[i];
            view.cam_from_origin =
                by.moved(view.cam_from_origin.relative_to(-origin)).relative_to(other.origin());
            for (const Blend blend : {Blend::lumigraph, Blend::average, Blend::best}) {
                const Picture a = given->picture(views[i], blend), b = other.picture(view, blend);
                std::size_t off = 0;
                for (std::size_t p = 0; p < a.rgba.size(); p += 4) {
                    int worst = 0;
                    for (std::size_t c = p; c < p + 4; ++c)
                        worst = std::max(worst, std::abs(int(a.rgba[c]) - int(b.rgba[c])));
                    off += worst > 2;
                }
                EXPECT_LE(double(off), most * double(a.rgba.size()) / 4)
                    << "view " << i << " blend " << int(blend) << ": " << off << " pixels";
            }
        }
    }

    void expect_same(const OtherFrame& by) const {
        const auto other = opened(by, "other");
        EXPECT_EQ(given->package.scene().effects, other->package.scene().effects);
        expect_same_coordinates(*other);
        expect_same_weight_maps(*other, by.scale);
        expect_same_pictures(*other, by);
    }
};

/// The PSNR between two pictures of the same size, in dB.
double psnr(const Picture& a, const Picture& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        squares += std::pow(double(a.rgba[i]) - double(b.rgba[i]), 2);
    return 10 * std::log10(255.0 * 255 * double(a.rgba.size()) / std::max(squares, 1e-9));
}

/// Adds a triangle that connects `corner` with the two vertices that are farthest in the +y direction.
void add_stray(SceneInput& scene, const Eigen::Vector3d& corner) {
    Mesh& mesh = scene.mesh;
    std::vector<std::uint32_t> by_y(mesh.positions.size());
    std::iota(by_y.begin(), by_y.end(), 0u);
    std::ranges::sort(by_y, std::ranges::greater(), [&](std::uint32_t v) { return mesh.positions[v].y(); });
    mesh.triangles.push_back({by_y[0], by_y[1], std::uint32_t(mesh.positions.size())});
    mesh.positions.push_back(corner);
    mesh.normals.push_back(Eigen::Vector3f::UnitZ());
    if (!mesh.colors.empty()) mesh.colors.push_back(mesh.colors.front());
    for (VertexField& field : mesh.scalars) field.values.push_back(float(by_y.size()));
}

Eigen::Matrix3d turned(double angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

}  // namespace

TEST_F(ScaleAndPlace, UnitsPositionAndOrientationDoNotMatter) {
    const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d here = Eigen::Vector3d::Zero();
    const OtherFrame cases[] = {{1e-4, here, none},
                                {1e4, here, none},
                                {1, here, turned(2.1, {0.3, -1, 0.7})},
                                {1, {5e5, 5e6, 120}, none},
                                {1e-4, {-5e5, 5e5, 5e5}, turned(1.3, {1, 0.2, 0.4})},
                                {1e4, {5e6, -5e6, 5e6}, turned(-2.8, {0.1, 0.9, -0.3})}};
    for (const OtherFrame& by : cases) {
        SCOPED_TRACE("scale " + std::to_string(by.scale) + ", moved by " + std::to_string(by.move.norm()) +
                     ", turned by " + std::to_string(Eigen::AngleAxisd(by.turn).angle()));
        expect_same(by);
    }
}

TEST_F(ScaleAndPlace, ScalingByAPowerOfTwoIsBitExact) {
    const auto other = opened(OtherFrame{.scale = 0x1p13}, "other");
    for (const std::uint32_t photo : given->photos) {
        EXPECT_EQ(given->texels(Type::weight_maps, photo, weight_map_level),
                  other->texels(Type::weight_maps, photo, weight_map_level));
        EXPECT_EQ(given->coordinates(photo), other->coordinates(photo));
    }
    const View a = view_of_photo(given->package.photos()[1], 1),
               b = view_of_photo(other->package.photos()[1], 1);
    EXPECT_EQ(given->picture(a, Blend::lumigraph).rgba, other->picture(b, Blend::lumigraph).rgba);
}

// A distant triangle does not make the rest of the scene less precise: the prediction of a held-out photo is
// as good, and the clusters and the extent of the scene stay the same.
TEST_F(ScaleAndPlace, StrayTriangleCostsNoPrecision) {
    struct Case {
        const char* name;
        OtherFrame by;
        Eigen::Vector3d corner;
    };
    for (const Case& c : {Case{"utm", {1, {5e5, -5.4e6, 120}}, {0, 0, 0}}, Case{"local", {}, {3, 1e6, -2}},
                          Case{"near plane", {}, {3, 1e9, -2}}}) {
        SCOPED_TRACE(c.name);
        SceneInput input = c.by.moved(scene);
        const auto without = opened(input, "without");
        add_stray(input, c.corner);
        const auto with = opened(input, "with");
        EXPECT_LT((with->origin() - without->origin()).norm(), 1);
        const package::SceneRecord &given = without->package.scene(), &other = with->package.scene();
        EXPECT_NEAR(other.reference_density, given.reference_density, 0.01 * given.reference_density);
        EXPECT_NEAR(double(other.clusters), double(given.clusters), 0.1 * double(given.clusters));
        // The stray triangle's edge within the scene is subdivided like other edges.
        EXPECT_NEAR(double(other.triangles), double(given.triangles), 64);
        const std::vector<std::uint32_t> others{0, 2};
        const Picture own = without->picture(view_of_photo(without->package.photos()[1], 1), Blend::best);
        const auto held_out = [&](Opened& o) {
            RenderSettings model_only;
            model_only.background = ShowBackground::off;
            return take_picture(o.renderer, view_of_photo(o.package.photos()[1], 1), model_only, others, 1);
        };
        const Picture a = held_out(*without), b = held_out(*with);
        EXPECT_NEAR(psnr(a, own), psnr(b, own), 0.1);
        EXPECT_GT(psnr(a, b), 45);
        const auto covered = [](const Opened& o) {
            return covered_area(o.package, photos_per_triangle(o.package));
        };
        for (std::size_t i = 0; i < coverage_classes.size(); ++i)
            EXPECT_NEAR(covered(*with)[i], covered(*without)[i], 0.02) << coverage_classes[i].name;
        EXPECT_NEAR(with->renderer.scene().size, without->renderer.scene().size, 1e-3);
    }
}
