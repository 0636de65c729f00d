// Reads back every float target of every kind of frame: no value may be infinite or NaN.
#include <Eigen/Geometry>
#include <array>
#include <fstream>
#include <limits>

#include "base/text/error.h"
#include "pipeline/run/settings.h"
#include "player/measure/bench/finite_targets.h"
#include "prepared_scene.h"

using namespace vantage;

namespace {

struct Named {
    std::string name;
    View view;
};

class FinitePictures : public PreparedScene {
  protected:
    std::vector<Named> views() const {
        const Eigen::Vector3d up = up_of(package->scene());
        const auto towards = [&](const Eigen::Vector3d& eye, const Eigen::Vector3d& target, double fov = 60) {
            return view_towards(eye, target, up, fov, 48, 36);
        };
        const auto positions = package->records<Eigen::Vector3f>(package::Type::positions);
        const Eigen::Vector3d vertex = positions[positions.size() / 2].cast<double>();
        const Pose photo = cam_from_origin(package->photos()[1]);
        return {{"a photo's own", own_view(2, 0.15)},
                {"between photos", between(0, 1, 48, 36)},
                {"inside the model", towards({0, 0, 0}, {1, 0.5, 0.2})},
                {"at a vertex", towards(vertex, vertex + Eigen::Vector3d(1, 1, 1))},
                {"edge-on", towards(vertex, vertex + Eigen::Vector3d(1, 0, 0), 120)},
                {"along up", towards({0, 0, 0}, up)},
                {"from behind", towards(-photo.center(), {0, 0, 0})},
                {"far away", towards(1e6 * photo.center(), {0, 0, 0})},
                {"extremely far away", towards({1e17, 0, 0}, {0, 0, 0})},
                {"looking away", towards(photo.center(), 2 * photo.center())},
                {"a tenth of a degree", towards(photo.center(), {0, 0, 0}, 0.1)},
                {"170 degrees", towards(photo.center(), {0, 0, 0}, 170)},
                {"a pixel", own_view(1, 1e-9)}};
    }
    std::size_t count(const Named& of, const RenderSettings& s, const std::string& what, int side = 1) {
        const Picture p = picture(of.view, s, side);
        const NonFinite found = count_non_finite(renderer->resources().targets);
        EXPECT_EQ(found.all(), 0u) << of.name << ", " << what << ": " << words(found);
        return found.all();
    }
};

std::vector<std::pair<std::string, RenderSettings>> kinds() {
    std::vector<std::pair<std::string, RenderSettings>> out;
    for (const Blend blend : {Blend::lumigraph, Blend::average, Blend::best})
        for (const bool filled : {false, true}) {
            RenderSettings s;
            s.blend = blend;
            s.fill_holes = filled;
            const std::string name = "blend " + std::to_string(int(blend)) + (filled ? ", filled" : "");
            out.emplace_back(name, s);
            s.weights.sharpness = 0.005;
            s.weights.exponent = 64;
            s.transients = true;
            out.emplace_back(name + ", sharp, transient masking", s);
        }
    RenderSettings shown;
    shown.fill_holes = true;
    shown.show = Show::sources;
    out.emplace_back("sources", shown);
    shown.show = Show::coverage;
    out.emplace_back("coverage", shown);
    RenderSettings fragment;
    fragment.coordinates = Coordinates::fragment;
    out.emplace_back("fragment", fragment);
    for (const Compare c : {Compare::side_by_side, Compare::swipe, Compare::difference}) {
        RenderSettings compared;
        compared.compare = c;
        compared.compare_photo = 1;
        out.emplace_back("compare " + std::to_string(int(c)), compared);
    }
    return out;
}

/// A wall whose vertex normals cancel out within each triangle, with degenerate triangles and colors of 0 and
/// 255.
class FinitePicturesOfOddModel : public FinitePictures {
  protected:
    void change(const std::filesystem::path& scene) const override {
        std::ofstream ply;
        for (const auto& f : std::filesystem::recursive_directory_iterator(scene))
            if (f.path().extension() == ".ply") ply.open(f.path());
        ASSERT_TRUE(ply.is_open());
        constexpr int n = 12;
        ply << "ply\nformat ascii 1.0\nelement vertex " << n * n
            << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float "
               "ny\n"
               "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
               "element face "
            << 2 * (n - 1) * (n - 1) << "\nproperty list uchar int vertex_indices\nend_header\n";
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)  // alternating normals
                ply << x - n / 2 << " 0 " << 0.5 * y << " 0 " << ((x + y) % 2 ? 1 : -1) << " 0 "
                    << ((x + y) % 3 ? 0 : 255) << ' ' << (x % 2 ? 0 : 255) << " 0\n";
        for (int y = 0; y + 1 < n; ++y)
            for (int x = 0; x + 1 < n; ++x) {
                const int a = y * n + x, b = (x + y) % 7 == 0 ? a : a + 1;
                ply << "3 " << a << ' ' << b << ' ' << a + n << "\n3 " << a + n << ' ' << a + 1 << ' '
                    << a + n + 1 << '\n';
            }
    }
    PrepareSettings settings() const override {
        PrepareSettings s;
        s.effects[Effect::vertex_colors] = EffectChoice::on;
        return s;
    }
};

}  // namespace

TEST_F(FinitePictures, EverySettingFromEveryView) {
    for (const Named& view : views())
        for (const auto& [name, s] : kinds()) count(view, s, name);
    count(views()[1], {}, "four samples per pixel", 2);
    RenderSettings fragment;
    fragment.coordinates = Coordinates::fragment;
    renderer->resources().trials = {.trilinear = false, .anisotropy = 4};
    for (const Named& view : views()) count(view, fragment, "4 taps, bilinear");
}

TEST_F(FinitePicturesOfOddModel, CancelingNormalsAndExtremeColors) {
    for (const Named& view : views())
        for (const Blend blend : {Blend::lumigraph, Blend::best}) {
            RenderSettings s;
            s.blend = blend;
            s.fill_holes = true;
            count(view, s, "blend " + std::to_string(int(blend)));
        }
    View large = between(1, 2, 400, 300);
    RenderSettings s;
    s.fill_holes = true;
    count({"large", large}, s, "shaded");
}

TEST_F(FinitePictures, CountsInjectedNonFiniteValues) {
    const Named view = views()[1];
    ASSERT_EQ(count(view, {}, "usual"), 0u);
    const std::size_t pixels = 48 * 36;
    const FrameTargets& t = renderer->resources().targets;
    const float bad = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
    const std::array<float, 4> one_bad{0, bad, 0, 1}, all_endless{infinite, -infinite, infinite, infinite};
    glClearNamedFramebufferfv(t.samples.front().sum_target.id(), GL_COLOR, 0, one_bad.data());
    EXPECT_EQ(count_non_finite(t).samples, pixels);
    glClearNamedFramebufferfv(t.sums_target(0).id(), GL_COLOR, 0, all_endless.data());
    EXPECT_EQ(count_non_finite(t).sums, 4 * pixels);
    glClearNamedFramebufferfv(t.surface().target.id(), GL_COLOR, 0, one_bad.data());
    EXPECT_EQ(count_non_finite(t).surface, pixels);
    EXPECT_EQ(count_non_finite(t).all(), 6 * pixels);
    std::string all = std::to_string(4 * pixels);
    all += " of the sums";  // in two steps, since g++ 12 warns about the sum of temporaries
    EXPECT_NE(words(count_non_finite(t)).find(all), std::string::npos);
    EXPECT_EQ(count(view, {}, "the next frame should clear all targets"), 0u);
}

TEST_F(FinitePictures, NonFiniteViewIsRejectedAndTheNextOneDrawn) {
    const View good = between(0, 1, 48, 36);
    const Picture before = picture(good, {});
    const double bad = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();
    std::vector<View> views;
    for (const double v : {bad, infinite, -infinite}) {
        views.insert(views.end(), 6, good);
        View* last = &views.back();
        (last - 0)->cam_from_origin.t.x() = v;
        (last - 1)->cam_from_origin.R(1, 2) = v;
        (last - 2)->intrinsics.fx = v;
        (last - 3)->intrinsics.fy = v;
        (last - 4)->intrinsics.cx = v;
        (last - 5)->intrinsics.cy = v;
    }
    views.insert(views.end(), 6, good);
    View* last = &views.back();
    (last - 0)->cam_from_origin.R.setZero();
    (last - 1)->cam_from_origin.t = {1e30, 0, 0};
    (last - 2)->intrinsics.fx = 0;
    (last - 3)->intrinsics.fy = -1;
    (last - 4)->cam_from_origin.R *= 3;
    (last - 5)->intrinsics.width = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        try {
            picture(views[i], {});
            ADD_FAILURE() << "view " << i << " was accepted";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::usage) << e.what();
        }
        if (views[i].intrinsics.width == 0) continue;
        RenderSettings frozen;
        frozen.weights_from = views[i];
        EXPECT_THROW(picture(good, frozen), Error) << i;
    }
    EXPECT_EQ(picture(good, {}).rgba, before.rgba);
    EXPECT_EQ(count_non_finite(renderer->resources().targets).all(), 0u);
}

TEST_F(FinitePictures, NonFiniteEyeOrTargetIsRejected) {
    for (const double far : {1e200, std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_THROW(view_towards({far, 0, 0}, {0, 0, 0}, {0, 0, 1}, 45, 10, 10), Error) << far;
}
