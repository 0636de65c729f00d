// Tests weights that are equal up to rounding, and weights that span twelve orders of magnitude.
#include "player/plan/selection/weights.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "prepared_scene.h"

using namespace vantage;

namespace {

package::PhotoRecord photo_at(const Eigen::Vector3d& center, const Eigen::Matrix3d& R, double fov = 60) {
    package::PhotoRecord p{};
    p.width = 1600, p.height = 1200;
    p.fx = p.fy = p.width / (2 * std::tan(fov * std::numbers::pi / 360));
    p.cx = 800, p.cy = 600;
    p.levels = 4;
    p.seen_distance = 10;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(p.R) = R;
    Eigen::Map<Eigen::Vector3d>(p.t) = -R * center;
    Eigen::Map<Eigen::Vector3d>(p.corrected_direction) = R.row(2);
    return p;
}

View view_at(const Eigen::Vector3d& eye, const Eigen::Matrix3d& R, double fov = 60) {
    const package::PhotoRecord p = photo_at(eye, R, fov);
    return view_of_photo(p, 1);
}

Eigen::Matrix3d turned(double x, double y, double z) {
    return (Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(y, Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(z, Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

Eigen::Vector3d random_unit(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

/// The weights of [M], computed independently in long double.
std::vector<double> reference(const View& view, const std::vector<package::PhotoRecord>& photos,
                              const WeightSettings& s) {
    const auto ramp = [&](const std::vector<long double>& values) {
        const auto [low, high] = std::ranges::minmax(values);
        std::vector<long double> out;
        for (const long double v : values)
            out.push_back(high > low ? std::max(1e-3L, 1 - (v - low) / (high - low)) : 1);
        return out;
    };
    std::vector<long double> distances, angles;
    for (const package::PhotoRecord& p : photos) {
        const Pose pose = cam_from_origin(p);
        distances.push_back((pose.center() - view.cam_from_origin.center()).cast<long double>().norm());
        const auto a = pose.direction().cast<long double>().eval(),
                   b = view.cam_from_origin.direction().cast<long double>().eval();
        angles.push_back(std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0L, 1.0L)));
    }
    const auto near = ramp(distances), alike = ramp(angles);
    std::vector<double> out;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        long double w = 1;
        if (s.distance) w *= std::pow(near[i], (long double)s.exponent);
        if (s.angle && s.angle_per_photo) w *= std::pow(alike[i], (long double)s.exponent);
        out.push_back(double(std::max(w, 1e-9L)));
    }
    return out;
}

/// Pixels that are colored in only one of two pictures, and the color differences in pixels that are colored
/// in both.
struct Compared {
    std::size_t lost = 0, colored = 0, off = 0;
    int worst = 0;
};
Compared compare(const Picture& before, const Picture& after) {
    Compared c;
    for (std::size_t i = 0; i < before.rgba.size(); i += 4) {
        if (before.rgba[i + 3] != 255) continue;
        ++c.colored;
        c.lost += after.rgba[i + 3] != 255;
        int off = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            off = std::max(off, std::abs(int(before.rgba[k]) - int(after.rgba[k])));
        c.off += off > 2;
        c.worst = std::max(c.worst, off);
    }
    return c;
}

class BlendedWeights : public PreparedScene {};

}  // namespace

TEST(DynamicWeights, EqualValuesGiveOne) {
    for (const std::size_t n : {1u, 2u, 500u})
        for (const double v : {0.0, 1e-300, 1.0, 1e300})
            for (const double w : nearest_is_one(std::vector<double>(n, v))) EXPECT_EQ(w, 1) << n << ' ' << v;
    const std::vector<double> one_only = nearest_is_one({7, 7, 0, 7});
    EXPECT_EQ(one_only, (std::vector<double>{1e-3, 1e-3, 1, 1e-3}));
}

TEST(DynamicWeights, SpanTwelveOrdersOfMagnitude) {
    std::vector<double> values;
    for (int i = 0; i <= 12; ++i) values.push_back(std::pow(10, i));
    const std::vector<double> w = nearest_is_one(values);
    for (std::size_t i = 0; i < w.size(); ++i) {
        EXPECT_NEAR(w[i], std::max(1e-3, 1 - (values[i] - 1) / (1e12 - 1)), 1e-12);
        EXPECT_TRUE(w[i] > 0 && w[i] <= 1);
    }
}

RC_GTEST_PROP(DynamicWeights, AnyValuesFallMonotonicallyFromOne, ()) {
    const auto values = *rc::gen::nonEmpty(rc::gen::container<std::vector<double>>(
        rc::gen::apply([](int mantissa, int exponent) { return mantissa * std::pow(10, exponent); },
                       rc::gen::inRange(0, 1000), rc::gen::inRange(-300, 301))));
    const std::vector<double> w = nearest_is_one(values);
    for (std::size_t i = 0; i < w.size(); ++i) {
        RC_ASSERT(w[i] >= 1e-3 && w[i] <= 1);
        if (values[i] == std::ranges::min(values)) RC_ASSERT(w[i] == 1);
        for (std::size_t k = 0; k < i; ++k) RC_ASSERT((w[k] - w[i]) * (values[k] > values[i] ? 1 : -1) <= 0);
    }
}

// Otherwise, rounding would decide which photo is shown.
TEST(DynamicWeights, RoundingOfEqualDistancesDoesNotMatter) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 100; ++trial) {
        const Eigen::Vector3d eye = random_unit(random) * std::pow(10, double(random() % 5));
        std::vector<package::PhotoRecord> photos;
        for (int i = 0; i < 40; ++i)  // on a sphere around the viewer, or all at the viewer
            photos.push_back(photo_at(eye + (trial % 2 ? 5.0 : 0.0) * random_unit(random),
                                      turned(0.1 * i, 0.2 * i, 0.3 * i)));
        WeightSettings s;
        s.exponent = 64;
        for (const double w : dynamic_weights(view_at(eye, turned(0, 0, 0)), photos, s))
            ASSERT_NEAR(w, 1, 1e-3) << "trial " << trial;
    }
}

TEST(DynamicWeights, RoundingOfEqualAnglesDoesNotMatter) {
    std::mt19937 random(2);
    for (const double away : {0.0, 0.4, std::numbers::pi / 2, std::numbers::pi}) {
        const Eigen::Matrix3d R = turned(0.3, 0.2, 0.1);
        std::vector<package::PhotoRecord> photos;
        for (int i = 0; i < 40; ++i)  // directions on a cone around the viewer's, with different rolls
            photos.push_back(photo_at(5 * random_unit(random), turned(0, 0, 0.37 * i) * turned(away, 0, 0) *
                                                                   turned(0, 0, 0.61 * i) * R));
        WeightSettings s;
        s.distance = false;
        s.angle_per_photo = true;
        s.exponent = 64;
        for (const double w : dynamic_weights(view_at({0, 0, 0}, R), photos, s))
            ASSERT_NEAR(w, 1, 1e-3) << "at distance " << away;
    }
}

TEST(DynamicWeights, MatchTheEquationsForOneTwoAndManyPhotos) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-3, 3);
    for (int trial = 0; trial < 60; ++trial) {
        const std::size_t n = trial % 3 == 0 ? 1 : trial % 3 == 1 ? 2 : 500;
        std::vector<package::PhotoRecord> photos;
        for (std::size_t i = 0; i < n; ++i)
            photos.push_back(
                photo_at(9 * random_unit(random), turned(angle(random), angle(random), angle(random))));
        const View view = view_at(3 * random_unit(random), turned(angle(random), angle(random), 0));
        for (const double exponent : {0.0, 1.0, 2.0, 64.0})
            for (const bool per_photo : {false, true}) {
                WeightSettings s;
                s.exponent = exponent;
                s.angle_per_photo = per_photo;
                const auto w = dynamic_weights(view, photos, s), truth = reference(view, photos, s);
                for (std::size_t i = 0; i < n; ++i)
                    ASSERT_NEAR(w[i], truth[i], 1e-6 * truth[i] * (1 + exponent)) << "trial " << trial;
            }
    }
}

TEST(DynamicWeights, AreDefinedForOppositeDirectionsAndAtACamera) {
    const Eigen::Matrix3d ahead = turned(0, 0, 0), back = turned(0, std::numbers::pi, 0);
    const std::vector photos{photo_at({0, 0, 0}, ahead), photo_at({0, 0, 0}, back),
                             photo_at({3, 0, 0}, ahead)};
    WeightSettings s;
    s.angle_per_photo = true;
    s.exponent = 1;
    const auto w = dynamic_weights(view_at({0, 0, 0}, ahead), photos, s);
    EXPECT_DOUBLE_EQ(w[0], 1) << "same position and direction";
    EXPECT_NEAR(w[1], 1e-3, 1e-12) << "same position, opposite direction";
    EXPECT_NEAR(w[2], 1e-3, 1e-12) << "same direction, most distant";
}

TEST(DynamicWeights, AreFiniteForExtremeFieldsOfView) {
    for (const double own : {0.1, 60.0, 170.0})
        for (const double wanted : {0.1, 60.0, 170.0}) {
            // Views from in front of the model, from its center, and facing away from it.
            std::vector<package::PhotoRecord> photos{photo_at({0, 0, -10}, turned(0, 0, 0), own),
                                                     photo_at({0, 0, 0}, turned(0, 0, 0), own),
                                                     photo_at({0, 0, -10}, turned(0, 3.1, 0), own)};
            photos[2].seen_distance = 0;
            const View view = view_at({0, 0, -10}, turned(0, 0, 0), wanted);
            WeightSettings s;
            s.fov_normalization = true;
            s.exponent = 1;
            const auto w = dynamic_weights(view, photos, s);
            for (const double x : w) EXPECT_TRUE(x > 0 && x <= 1) << own << ' ' << wanted << ' ' << x;
            EXPECT_EQ(w[2], 1) << "the camera sees nothing, so it stays at the viewpoint";
            // [M] 4.1 to 4.3: w = 2 d tan(f / 2), d' = w / (2 tan(f' / 2)), with d = 10.
            const double rad = std::numbers::pi / 360;
            const double moved = 10 * (1 - std::tan(own * rad) / std::tan(wanted * rad));
            const std::vector<double> truth =
                nearest_is_one({std::abs(moved), std::abs(10 + moved), 0}, 1e-3, 1e-8);
            for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(w[i], truth[i], 1e-6) << own << ' ' << wanted;
        }
}

namespace {

struct Extreme {
    const char* name;
    RenderSettings settings;
};

std::vector<Extreme> extremes() {
    std::vector<Extreme> out;
    for (const Blend blend : {Blend::lumigraph, Blend::average, Blend::best}) {
        RenderSettings s;
        s.blend = blend;
        out.push_back({"usual", s});
        s.weights.sharpness = 0.005;
        out.push_back({"sharpness 0.005", s});
        s.weights.exponent = 64;
        s.weights.angle_per_photo = true;
        out.push_back({"exponent 64, angle by photo", s});
        s.weights.angle_per_photo = false;
        out.push_back({"exponent 64, sharpness 0.005", s});
        s.transients = true;
        out.push_back({"exponent 64, sharpness 0.005, transient masking", s});
        s = {};
        s.blend = blend;
        s.weights.sharpness = 3;
        s.weights.exponent = 0;
        out.push_back({"exponent 0, sharpness 3", s});
        WeightSettings& w = s.weights;
        w.angle_weight = w.depth_weight = w.border_weight = w.transient_mask = w.distance = w.angle = false;
        out.push_back({"all weights off", s});
    }
    return out;
}

}  // namespace

// Weights that underflow would leave holes.
TEST_F(BlendedWeights, ExtremeSettingsLoseNoPixel) {
    for (const bool own : {true, false}) {
        const View view = own ? own_view(2, 0.3) : between(0, 1, 120, 90);
        const Picture usual = picture(view, {});
        for (const Extreme& e : extremes()) {
            const Compared c = compare(usual, picture(view, e.settings));
            ASSERT_GT(c.colored, 3000u);
            EXPECT_EQ(c.lost, 0u) << e.name << ", blend " << int(e.settings.blend);
        }
    }
}

namespace {

/// The weighted mean of `colors`, with one pass per color, accumulated in the same way as resolve accumulates
/// the output of blend.frag.
double summed(const std::vector<double>& weights, const std::vector<double>& colors) {
    FrameTargets t = make_frame_targets({1, 1});
    const std::array<float, 4> zero{};
    glClearNamedFramebufferfv(t.sums_target(0).id(), GL_COLOR, 0, zero.data());
    const gl::Texture one = gl::make_texture_2d("a pass", GL_RGBA32F, 1, 1);
    const gl::Program add =
        gl::make_program("add", {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, "resolve.frag"}});
    const gl::VertexArray none = gl::make_vertex_array("none");
    glBindFramebuffer(GL_FRAMEBUFFER, t.sums_target(0).id());
    glViewport(0, 0, 1, 1);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glUseProgram(add.id());
    glUniform1i(shader::takes_one_uniform, GL_FALSE);
    glUniform1f(shader::max_uniform, 0);
    glUniform2i(shader::frame_size_uniform, 1, 1);
    glUniform3f(shader::vignetting_uniform, 0, 0, 0);
    glUniform3f(shader::lens_uniform, 0, 0, 0);
    glUniform1f(shader::progress_uniform, 1);
    glBindVertexArray(none.id());
    for (std::size_t i = 0; i < weights.size(); ++i) {
        // resolve squares the stored square root and outputs (color, 1); blending with a constant turns that
        // into (color * weight, weight).
        const auto c = float(std::sqrt(colors[i])), w = float(weights[i]);
        const std::array<float, 4> texel{c, c, c, 1};
        glTextureSubImage2D(one.id(), 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, texel.data());
        glUniform3f(shader::exposure_uniform, w, w, w);
        glBindTextureUnit(shader::sums_unit, one.id());
        glBindTextureUnit(shader::surface_unit, one.id());
        // Color is scaled by the uniform and alpha by the blend constant; blend constants are clamped to 1,
        // which no weight exceeds.
        glBlendFuncSeparate(GL_ONE, GL_ONE, GL_CONSTANT_ALPHA, GL_ONE);
        glBlendColor(0, 0, 0, w);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    std::array<float, 4> sum{};
    glGetTextureImage(t.sums[0].id(), 0, GL_RGBA, GL_FLOAT, sizeof sum, sum.data());
    gl::check("adding");
    return double(sum[0]) / double(sum[3]);
}

}  // namespace

TEST_F(BlendedWeights, SumsOverTwelveOrdersOfMagnitudeMatchDoubles) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> orders(-12, 0), color(0.02, 1);
    double worst = 0;
    for (int trial = 0; trial < 12; ++trial) {
        std::vector<double> weights, colors;
        for (int i = 0; i < (trial < 8 ? 8 : 500); ++i) {
            weights.push_back(std::pow(10, orders(random)));
            colors.push_back(color(random));
        }
        double sum = 0, all = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * colors[i], all += weights[i];
        const double truth = sum / all;
        worst = std::max(worst, std::abs(summed(weights, colors) / truth - 1));
    }
    std::printf("off by at most %.2g\n", worst);
    EXPECT_LT(worst, 1e-4);
}
