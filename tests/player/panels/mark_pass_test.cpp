// Marks have the correct pixel coverage, even if they are thinner than a pixel.
#include "player/panels/mark_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "tests/player/panels/eye_target.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

constexpr MarkColor white{1, 1, 1, 1};

void draw(const Marks& marks, const EyeTarget& picture) {
    MarkPass pass;
    pass.upload(marks);
    pass.draw(picture.eye);
}

/// The sum of a column of the picture, which is the number of pixels that marks cover.
double column(const EyeTarget& picture, int x) {
    const FrameSize size = frame_size(picture.eye.view);
    const std::vector<float> values = picture.values();
    double sum = 0;
    for (int y = 0; y < size.height; ++y) sum += double(values[std::size_t(y * size.width + x)]);
    return sum;
}

/// The number of pixels that differ from the exact value along their ray by more than half the value of
/// white.
int wrong_pixels(const EyeTarget& picture, const std::function<bool(const Vector3d&)>& shows) {
    const FrameSize size = frame_size(picture.eye.view);
    const std::vector<float> values = picture.values();
    int wrong = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float v = values[std::size_t(y * size.width + x)];
            EXPECT_TRUE(std::isfinite(v));
            wrong += std::abs(v - (shows(picture.direction(x, y)) ? 1.0f : 0.0f)) > 0.55f;
        }
    return wrong;
}

}  // namespace

TEST(MarkPass, LinesAreAsWideAsTheyAreInTheScene) {
    const gl::HeadlessContext context;
    const double focal = 20 * 180 / std::numbers::pi;
    for (const double pixels : {0.3, 0.7, 1.0, 2.5, 10.0})
        for (const double slope : {0.0, 0.02}) {
            EyeTarget picture(200, 100);
            Marks marks;
            add_line(marks, {-0.2, 0.003, 1}, {0.2, 0.003 + 0.4 * slope, 1}, {pixels / focal, 0}, white);
            draw(marks, picture);
            for (const int x : {20, 63, 150})
                EXPECT_NEAR(column(picture, x), pixels, 0.02 * pixels + 0.01) << slope;
        }
}

TEST(MarkPass, LinesTaperWithDistanceButNotBelowTheirLeastWidth) {
    const gl::HeadlessContext context;
    EyeTarget picture(400, 200);
    Marks marks;
    add_line(marks, {-0.05, 0, 0.5}, {10, 0, 60}, {0.004, 2}, white);
    draw(marks, picture);
    const double focal = 20 * 180 / std::numbers::pi;
    for (int x = 100; x < 380; x += 20) {
        // The pixel's position t on the line: -0.05 + 10.05 t = u (0.5 + 59.5 t).
        const double u = (x + 0.5 - 200) / focal, t = (0.5 * u + 0.05) / (10.05 - 59.5 * u);
        if (t < 0.001 || t > 0.99) continue;
        EXPECT_NEAR(column(picture, x), std::max(2.0, 0.004 * focal / (0.5 + 59.5 * t)), 0.1) << x;
    }
}

TEST(MarkPass, APointerFromBehindTheEyeIsSeenAsFarAsItIsAhead) {
    const gl::HeadlessContext context;
    EyeTarget picture(200, 150, 2);
    const Vector3d from(0.3, 0.2, -1), to(-0.1, -0.1, 1.5);
    Marks marks;
    add_line(marks, from, to, {0.02, 0}, white);
    draw(marks, picture);
    const Vector3d along = to - from;
    const int wrong = wrong_pixels(picture, [&](const Vector3d& sight) {
        // The nearest points of two lines.
        const Vector3d n = sight.cross(along);
        const double t = -from.cross(sight).dot(n) / n.squaredNorm(),
                     far = from.cross(along).dot(n) / n.squaredNorm();
        return t <= 1 && far > 0.01 && std::abs(from.dot(n)) / n.norm() < 0.01;
    });
    EXPECT_LT(wrong, 40);  // where it passes the eye, a flat ribbon is not a cylinder
    EXPECT_GT(std::ranges::count_if(picture.values(), [](float v) { return v > 0.9f; }), 300);
}

TEST(MarkPass, APathIsAsTransparentWhereItBendsAsElsewhere) {
    const gl::HeadlessContext context;
    EyeTarget picture(300, 200);
    std::vector<Vector3d> points;
    for (int i = 0; i <= 20; ++i)
        points.emplace_back(-0.1 + 0.01 * i, 0.06 - 0.02 * i + 0.001 * i * i, 1 + 0.02 * i);
    Marks marks;
    add_path(marks, points, {0.01, 0}, {1, 1, 1, 0.5f}, {1, 1, 1, 0.5f});
    draw(marks, picture);
    const std::vector<float> values = picture.values();
    EXPECT_LT(std::ranges::max(values), 0.51f);
    // There are no gaps: a pixel between two covered pixels is covered.
    int gaps = 0;
    for (int y = 1; y < 199; ++y)
        for (int x = 1; x < 299; ++x) {
            const auto v = [&](int dx, int dy) { return values[std::size_t((y + dy) * 300 + x + dx)]; };
            gaps += v(0, 0) < 0.4f &&
                    ((v(-1, 0) > 0.49f && v(1, 0) > 0.49f) || (v(0, -1) > 0.49f && v(0, 1) > 0.49f));
        }
    EXPECT_EQ(gaps, 0);
}

TEST(MarkPass, RingsAndBallsAreWhereRaysMeetThem) {
    const gl::HeadlessContext context;
    const Vector3d middle(0.1, 0.3, 1.2);
    for (const double inner : {0.0, 0.1}) {
        EyeTarget picture(300, 200, 5);
        Marks marks;
        add_ring(marks, middle, {0, -2, 0.1}, inner, 0.3, white);
        draw(marks, picture);
        const Vector3d normal = Vector3d(0, -2, 0.1).normalized();
        EXPECT_LT(wrong_pixels(picture,
                               [&](const Vector3d& sight) {
                                   const double t = middle.dot(normal) / sight.dot(normal),
                                                r = (t * sight - middle).norm();
                                   return t > 0 && r < 0.3 && r >= inner;
                               }),
                  3);
    }
    for (const Vector3d& at : {Vector3d(0, 0, 1), Vector3d(0.3, -0.15, 0.5), Vector3d(0.05, 0, 0.25)}) {
        EyeTarget picture(300, 200, 5);
        Marks marks;
        add_ball(marks, at, {0.1, 0}, {0, 0, 0, 1});
        picture.fill({1, 1, 1, 1});
        draw(marks, picture);
        EXPECT_LT(
            wrong_pixels(picture,
                         [&](const Vector3d& sight) { return sight.cross(at).norm() / sight.norm() >= 0.1; }),
            3);
    }
}

TEST(MarkPass, APictureIsShownAsItIs) {
    const gl::HeadlessContext context;
    EyeTarget picture(100, 100);
    for (const bool decodes : {false, true}) {
        const gl::Texture photos =
            gl::make_texture_array("photos", decodes ? GL_SRGB8_ALPHA8 : GL_RGBA8, 4, 4, 2, GL_NEAREST);
        std::vector<std::uint8_t> pixels;
        for (int i = 0; i < 16; ++i)
            for (const int c : {16 * i, 128, 255 - 16 * i, 255}) pixels.push_back(std::uint8_t(c));
        glTextureSubImage3D(photos.id(), 0, 0, 0, 1, 4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        Marks marks;
        add_line(marks, {0.03, -0.04, 1}, {0.03, 0.04, 1}, {0, 4}, white);
        add_picture(marks, {-0.02, -0.02, 1}, {0.02, -0.02, 1}, {-0.02, 0.02, 1},
                    {.texture = photos.id(), .layer = 1, .part = {0, 0, 0.5f, 0.5f}, .decodes = decodes},
                    white);
        draw(marks, picture);
        // The first two rows and columns of the texture, whose texels are 23 pixels wide.
        for (int i = 0; i < 4; ++i) {
            const auto seen = picture.at(38 + 23 * (i % 2), 38 + 23 * (i / 2));
            const int pixel = i % 2 + 4 * (i / 2);
            EXPECT_NEAR(seen[0], float(16 * pixel) / 255, 2e-3f);
            EXPECT_NEAR(seen[1], 128 / 255.0f, 2e-3f);
            EXPECT_NEAR(seen[2], float(255 - 16 * pixel) / 255, 2e-3f);
        }
    }
}

TEST(MarkPass, WhatIsBehindTheModelIsFaint) {
    const gl::HeadlessContext context;
    EyeTarget picture(100, 80);
    const gl::Texture depth = gl::make_texture_2d("depth", GL_R32F, 100, 80);
    const std::vector<float> depths(8000, 0.1f / 2);  // 2 away
    glTextureSubImage2D(depth.id(), 0, 0, 0, 100, 80, GL_RED, GL_FLOAT, depths.data());
    picture.eye.depth = {depth.id(), {0, 0.1}, {100, 80}};
    Marks marks;
    add_ring(marks, {-0.02, 0, 1}, {0, 0, 1}, 0, 0.01, white);
    add_ring(marks, {0.06, 0, 3}, {0, 0, 1}, 0, 0.03, white);
    add_ring(marks, {0, 0.04, 2}, {0, 0, 1}, 0, 0.02, white);  // on it
    draw(marks, picture);
    EXPECT_NEAR(picture.at(27, 40)[0], 1, 1e-5f);
    EXPECT_NEAR(picture.at(73, 40)[0], 0.25f, 1e-5f);
    EXPECT_NEAR(picture.at(50, 63)[0], 1, 1e-5f);
}

TEST(MarkPass, MarksWithoutAPlaceAreSkipped) {
    const gl::HeadlessContext context;
    EyeTarget picture(50, 50);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Marks marks;
    add_line(marks, {nan, 0, 1}, {0, 0, 1}, {0.1, 1}, white);
    add_ring(marks, {0, 0, 1}, {0, 0, 0}, 0, 1, white);
    add_ball(marks, {0, 0, std::numeric_limits<double>::infinity()}, {0.1, 1}, white);
    EXPECT_TRUE(marks.marks.empty());
    add_line(marks, {0, 0, 1}, {0, 0, 1}, {0, 3}, white);     // a dot
    add_line(marks, {0, 0, 0}, {0, 0, -1}, {0.1, 3}, white);  // behind
    add_ball(marks, {0, 0, 0}, {0.1, 0}, white);              // around the eye
    draw(marks, picture);
    for (const float v : picture.values()) ASSERT_TRUE(std::isfinite(v));
    EXPECT_GT(picture.at(25, 25)[0], 0.9f);
    EXPECT_EQ(picture.at(10, 25)[0], 0);
}
