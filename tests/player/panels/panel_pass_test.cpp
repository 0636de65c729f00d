// A panel is drawn correctly from any distance: text is sharp, and no pixels beyond the panel are covered.
#include "player/panels/panel_pass.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <stb_truetype.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>

#include "tests/player/panels/eye_target.h"

using namespace vantage;
using Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr const char* text_font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// Content that `draw` adds to ImGui's background, on a panel of 400 * 300 pixels whose text is 25 pixels
/// high.
class Drawn {
  public:
    explicit Drawn(const std::function<void(ImDrawList&)>& draw)
        : imgui_(ImGui::CreateContext(), &ImGui::DestroyContext) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(400, 300);
        pass_ = std::make_unique<PanelPass>(build_distance_field_font(*io.Fonts, 25));
        io.Fonts->SetTexID(ImTextureID(std::uintptr_t(pass_->font())));
        ImGui::NewFrame();
        draw(*ImGui::GetBackgroundDrawList());
        ImGui::Render();
        drawing_.upload(lists_of(*ImGui::GetDrawData()));
    }
    void on(const Panel& panel, const EyePicture& eye) { pass_->draw(drawing_, panel, eye); }

  private:
    gl::HeadlessContext context_;
    std::unique_ptr<ImGuiContext, void (*)(ImGuiContext*)> imgui_;
    std::unique_ptr<PanelPass> pass_;
    PanelDrawing drawing_;
};

/// A panel whose pixels are one millimeter wide and whose center is straight ahead.
Panel panel_ahead(double away) {
    return {.origin = {-0.2, -0.15, away}, .unit = 0.001, .width = 400, .height = 300};
}

void fill_all(ImDrawList& list) { list.AddRectFilled(ImVec2(0, 0), ImVec2(400, 300), IM_COL32_WHITE); }

/// The left and right edges of the letter l, in panel pixels from the start of a text that is 25 pixels high.
Vector2d edges_of_l() {
    std::ifstream file(text_font, std::ios::binary);
    const std::vector<unsigned char> bytes(std::istreambuf_iterator<char>(file), {});
    stbtt_fontinfo font;
    EXPECT_TRUE(stbtt_InitFont(&font, bytes.data(), 0));
    int left = 0, right = 0;
    stbtt_GetCodepointBox(&font, 'l', &left, nullptr, &right, nullptr);
    const double scale = double(stbtt_ScaleForPixelHeight(&font, 25));
    return {left * scale, right * scale};
}

struct Stroke {
    double middle, width, rise;  ///< pixels; `rise`: the distance from 10% to 90% of the peak coverage
};

/// The stroke of an "l" at panel pixel (200, 140), viewed head-on, from pictures shifted by fractions of a
/// pixel.
Stroke stroke_seen(double away) {
    constexpr int parts = 16, width = 200;
    Drawn l([](ImDrawList& list) { list.AddText(ImVec2(200, 140), IM_COL32_WHITE, "l"); });
    EyeTarget picture(width, 60);
    std::vector<double> profile(std::size_t(width * parts));
    for (int i = 0; i < parts; ++i) {
        picture.fill({0, 0, 0, 1});
        picture.eye.view.intrinsics.cx = width / 2.0 - double(i) / parts;
        l.on(panel_ahead(away), picture.eye);
        const std::vector<float> values = picture.values();
        for (int x = 0; x < width; ++x)
            profile[std::size_t(x * parts + i)] = double(values[std::size_t(30 * width + x)]);
    }
    double sum = 0, moment = 0;
    for (std::size_t i = 0; i < profile.size(); ++i)
        sum += profile[i] / parts, moment += profile[i] / parts * (double(i) / parts + 0.5);
    const double most = *std::ranges::max_element(profile);
    const auto first_above = [&](double share) {
        return double(std::ranges::find_if(profile, [&](double v) { return v >= share * most; }) -
                      profile.begin()) /
               parts;
    };
    return {moment / sum - width / 2.0, sum, first_above(0.9) - first_above(0.1)};
}

}  // namespace

TEST(PanelPass, TextIsSharpFromAnyDistance) {
    if (!std::filesystem::exists(text_font)) GTEST_SKIP() << "needs DejaVu Sans";
    const Vector2d edges = edges_of_l();
    for (const double away : {0.3, 1.0, 3.0}) {
        const double focal = 20 * 180 / std::numbers::pi, pixels = 0.001 * focal / away;  // per panel pixel
        const Stroke seen = stroke_seen(away);
        EXPECT_LE(seen.rise, 1.5) << away;
        EXPECT_NEAR(seen.width, (edges.y() - edges.x()) * pixels, 0.15) << away;
        EXPECT_NEAR(seen.middle, (edges.x() + edges.y()) / 2 * pixels, 0.15) << away;
    }
}

TEST(PanelPass, TinyTextIsAsBrightAsItShouldBe) {
    // From afar, a line of text is a gray bar that emits the same light as the text does nearby.
    Drawn text(
        [](ImDrawList& list) { list.AddText(ImVec2(60, 140), IM_COL32_WHITE, "Hamburgefonstiv 0123"); });
    const auto light = [&](double away) {
        EyeTarget picture(1400, 200);
        text.on(panel_ahead(away), picture.eye);
        double sum = 0;
        for (const float v : picture.values()) sum += double(v);
        return sum * away * away;
    };
    const double nearby = light(0.5);
    for (const double away : {2.0, 4.0, 6.0, 8.0}) EXPECT_NEAR(light(away) / nearby, 1, 0.12) << away;
}

TEST(PanelPass, ShowsEachPlaceWhereARayMeetsIt) {
    Drawn white(fill_all);
    EyeTarget picture(160, 120, 2);
    // The positions include a panel beside the eye that extends from in front of it to behind it, and a panel
    // that contains the eye.
    for (const double turn : {0.0, 0.5, 1.2, 1.5, -1.3})
        for (const Vector3d& middle :
             {Vector3d(0, 0, 0.3), Vector3d(0.03, 0, 0.1), Vector3d(-0.05, 0.02, 0), Vector3d(0, 0, 0)}) {
            Panel panel = panel_ahead(0);
            panel.right = Eigen::AngleAxisd(turn, Vector3d::UnitY()) * Vector3d::UnitX();
            panel.origin = middle - 0.2 * panel.right - 0.15 * panel.down;
            picture.fill({0, 0, 0, 1});
            white.on(panel, picture.eye);
            const std::vector<float> values = picture.values();
            const Vector3d normal = panel.right.cross(panel.down);
            if (std::abs(normal.dot(middle)) < 0.011) continue;  // as near as the near plane
            const bool front = normal.dot(middle) > 0;
            int wrong = 0;
            for (int y = 0; y < 120; ++y)
                for (int x = 0; x < 160; ++x) {
                    Panel seen = panel;
                    if (!front)
                        seen.right = -panel.right, seen.origin = middle - 0.2 * seen.right - 0.15 * seen.down;
                    const Vector3d along = picture.direction(x, y);
                    const auto hit = pixel_on(seen, {0, 0, 0}, along);
                    const float expected = hit && hit->distance > picture.eye.nearest ? 1 : 0;
                    const float v = values[std::size_t(y * 160 + x)];
                    ASSERT_TRUE(std::isfinite(v));
                    wrong += std::abs(v - expected) > 0.01f;
                }
            EXPECT_LT(wrong, 60) << turn << " " << middle.transpose();  // at its edges
        }
}

TEST(PanelPass, KeepsToClipRectangles) {
    Drawn clipped([](ImDrawList& list) {
        list.PushClipRect(ImVec2(100, 80), ImVec2(300, 200));
        fill_all(list);
        list.AddText(nullptr, 200, ImVec2(20, 60), IM_COL32_WHITE, "####");
        list.PopClipRect();
    });
    EyeTarget picture(500, 400);
    Panel panel = panel_ahead(1);
    panel.right = Eigen::AngleAxisd(0.6, Vector3d::UnitY()) * Eigen::AngleAxisd(0.1, Vector3d::UnitZ()) *
                  Vector3d::UnitX();
    panel.down = Eigen::AngleAxisd(0.6, Vector3d::UnitY()) * Eigen::AngleAxisd(0.1, Vector3d::UnitZ()) *
                 Vector3d::UnitY();
    clipped.on(panel, picture.eye);
    const std::vector<float> values = picture.values();
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 500; ++x) {
            const auto hit = pixel_on_plane(panel, {0, 0, 0}, picture.direction(x, y));
            ASSERT_TRUE(hit);
            const Vector2d p = hit->pixel;
            const double inside = std::min({p.x() - 100, 300 - p.x(), p.y() - 80, 200 - p.y()});
            const float v = values[std::size_t(y * 500 + x)];
            if (inside > 0) {
                ASSERT_NEAR(v, 1, 1e-6) << x << " " << y;
            }
            if (inside < -2) {
                ASSERT_EQ(v, 0) << x << " " << y;
            }
        }
}

TEST(PanelPass, ShinesThroughTheModelInFrontOfIt) {
    Drawn white(fill_all);
    EyeTarget picture(100, 80);
    // On the left, the model is nearer than the panel; in the middle, it is farther away; on the right, there
    // is no model.
    constexpr float a = -0.001f, b = 0.05f;
    std::vector<float> depths(128 * 96, 1);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 100; ++x)
            depths[std::size_t(y * 128 + x)] = x < 30 ? a + b / 0.9f : x < 60 ? a + b / 1.1f : 0;
    for (int x = 0; x < 100; ++x) depths[std::size_t(x)] = a + b / 0.9f;  // the picture's top row
    const gl::Texture depth = gl::make_texture_2d("depth", GL_R32F, 128, 96);
    glTextureSubImage2D(depth.id(), 0, 0, 0, 128, 96, GL_RED, GL_FLOAT, depths.data());
    picture.eye.depth = {depth.id(), {a, b}, {100, 80}};
    for (const bool flip : {false, true}) {
        picture.eye.flip = flip;
        picture.fill({0.2f, 0.2f, 0.2f, 1});
        white.on(panel_ahead(1), picture.eye);
        const int top = flip ? 79 : 0;
        EXPECT_NEAR(picture.at(10, 40)[0], 0.2f + 0.25f * 0.8f, 1e-5f);
        EXPECT_NEAR(picture.at(45, 40)[0], 1, 1e-5f);
        EXPECT_NEAR(picture.at(80, 40)[0], 1, 1e-5f);
        EXPECT_NEAR(picture.at(80, top)[0], 0.4f, 1e-5f);
        EXPECT_NEAR(picture.at(80, 79 - top)[0], 1, 1e-5f);
    }
}

TEST(PanelPass, ShowsPicturesAmongText) {
    gl::Texture photo;
    const auto draw = [&](ImDrawList& list) {
        const std::array<std::uint8_t, 16> pixels{255, 0, 0,   255, 0,   255, 0,   255,
                                                  0,   0, 255, 255, 255, 255, 255, 128};
        photo = gl::make_texture_2d("photo", GL_RGBA8, 2, 2);
        glTextureSubImage2D(photo.id(), 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        fill_all(list);
        list.AddRectFilled(ImVec2(180, 130), ImVec2(220, 170), IM_COL32_BLACK);
        list.AddImage(ImTextureID(std::uintptr_t(photo.id())), ImVec2(180, 130), ImVec2(220, 170));
    };
    Drawn drawn(draw);
    for (const bool flip : {false, true}) {
        EyeTarget picture(100, 80);
        picture.eye.flip = flip;
        drawn.on(panel_ahead(1), picture.eye);
        const int up = flip ? 45 : 34, down = 79 - up;
        EXPECT_EQ(picture.at(40, up), (std::array<float, 4>{1, 0, 0, 1}));
        EXPECT_EQ(picture.at(60, up), (std::array<float, 4>{0, 1, 0, 1}));
        EXPECT_EQ(picture.at(40, down), (std::array<float, 4>{0, 0, 1, 1}));
        EXPECT_NEAR(picture.at(60, down)[0], 128 / 255.0f, 1e-3f);
        EXPECT_EQ(picture.at(5, 5), (std::array<float, 4>{1, 1, 1, 1}));
    }
    photo = {};
}
