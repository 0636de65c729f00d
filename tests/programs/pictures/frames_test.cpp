// Tests that alternative ways to draw a frame give the same picture: photos blended pixel by pixel or by
// drawing the model again, and frames smaller than their render targets.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "base/gl/context.h"
#include "player/composition/enlargement.h"
#include "player/composition/object_set.h"
#include "player/render/picture.h"
#include "player/render/timing/pace.h"
#include "player/survey/section.h"
#include "tests/made_scenes.h"
#include "tests/programs/garden_package.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

/// Frames of a package with a background.
class Frames : public GardenPackage {
  protected:
    void SetUp() override {
        GardenPackage::SetUp();
        make_package({{Effect::background, EffectChoice::on}, {Effect::per_fragment, EffectChoice::on}});
    }
    /// A photo's own view, a view between photos, and a view from so close that triangles extend behind
    /// the viewer.
    static std::vector<View> views(const PackageReader& package) {
        std::vector<View> out;
        for (const double ahead : {0.0, 1.5, 4.0}) {
            View view = view_of_photo(package.photos()[1], 0.8);
            view.cam_from_origin.t -= Eigen::Vector3d(0.1 * ahead, 0.2 * ahead, ahead);
            out.push_back(view);
        }
        return out;
    }
};
class FramesAtLength : public Frames {};

struct Difference {
    int most = 0;
    double share_above_one = 0, share_above_24 = 0;
};
Difference difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    Difference d;
    std::size_t above_one = 0, above_24 = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const int off = std::abs(int(a[i]) - int(b.at(i)));
        d.most = std::max(d.most, off);
        above_one += off > 1;
        above_24 += off > 24;
    }
    d.share_above_one = double(above_one) / double(std::max<std::size_t>(1, a.size()));
    d.share_above_24 = double(above_24) / double(std::max<std::size_t>(1, a.size()));
    return d;
}

/// The time in milliseconds from the call of `draw` until the graphics card has finished.
double ms_of(const std::function<void()>& draw) {
    const auto begin = std::chrono::steady_clock::now();
    draw();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// Compares a picture that is cut by sections with rays that are clipped by the same sections.
void expect_cut(const PackageReader& package, const View& view, std::vector<SectionPlane> sections,
                std::span<const std::uint32_t> photos) {
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    settings.sections = std::move(sections);
    take_picture(renderer, view, settings, photos, 1);
    const std::vector<std::uint32_t> cut = read_triangles(renderer.resources().targets);
    const std::vector<SectionPlane> planes = std::exchange(settings.sections, {});
    take_picture(renderer, view, settings, photos, 1);
    const std::vector<std::uint32_t> whole = read_triangles(renderer.resources().targets);
    const PlanScene& scene = renderer.scene();
    const std::uint32_t of_mesh = scene.clusters[scene.first_surrounding].first_triangle;
    std::size_t changed = 0, wrong = 0;
    for (int y = 0; y < view.intrinsics.height; ++y)
        for (int x = 0; x < view.intrinsics.width; ++x) {
            const auto at = std::size_t(y * view.intrinsics.width + x);
            const Ray ray = ray_through(view, {x + 0.5, y + 0.5});
            const auto hit = first_hit(scene, ray, behind(planes, ray));
            const std::uint32_t shown = cut[at] > of_mesh ? 0 : cut[at];
            wrong += shown != (hit ? hit->triangle + 1 : 0);
            changed += cut[at] != whole[at];
        }
    EXPECT_GT(changed, cut.size() / 50) << "the section should remove a part of the model";
    EXPECT_LT(wrong, cut.size() / 200) << "except at edges";
}

/// The largest difference between two pictures of the frame that was drawn last. Pixels whose triangle is
/// seen at less than 3 degrees are excluded, because derivatives there do not equal the differences
/// between neighboring pixels.
int largest_difference(Renderer& renderer, const View& view, const Picture& a, const Picture& b) {
    constexpr double grazing = 0.05;
    const std::vector<std::uint32_t> triangles = read_triangles(renderer.resources().targets);
    const PlanScene& scene = renderer.scene();
    const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
        return scene.positions[scene.indices[i]].cast<double>();
    };
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const int off = std::abs(int(a.rgba[i]) - int(b.rgba[i]));
        if (off <= most || triangles[i / 4] == 0) continue;
        const std::size_t t = 3 * (std::size_t(triangles[i / 4]) - 1), x = i / 4 % std::size_t(a.width),
                          y = i / 4 / std::size_t(a.width);
        const Eigen::Vector3d n = (corner(t + 1) - corner(t)).cross(corner(t + 2) - corner(t)).normalized(),
                              ray = ray_through(view, {double(x) + 0.5, double(y) + 0.5}).along.normalized();
        if (std::abs(n.dot(ray)) > grazing) most = off;
    }
    return most;
}

}  // namespace

TEST_F(FramesAtLength, PhotosBlendedByPixelLookAsOnTheModelDrawnAgain) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    for (const View& view : views(package))
        for (const Blend blend : {Blend::lumigraph, Blend::average, Blend::best})
            for (const auto& [transients, background] : {std::pair(false, ShowBackground::off),
                                                         {true, ShowBackground::off},
                                                         {false, ShowBackground::on}}) {
                RenderSettings settings;
                settings.blend = blend;
                settings.transients = transients;
                settings.background = background;
                settings.photos_per_pass = 3;  // so that there are several passes
                settings.coordinates = Coordinates::fragment;
                settings.fill_holes = true;
                renderer.resources().trials.by_triangle = true;
                const Picture by_pixel = take_picture(renderer, view, settings, all(package), 1);
                renderer.resources().trials.by_triangle = false;
                const Picture by_model = take_picture(renderer, view, settings, all(package), 1);
                EXPECT_LT(by_pixel.report.draws, by_model.report.draws) << "the two methods must differ";
                const Difference d = difference(by_pixel.rgba, by_model.rgba);
                if (background == ShowBackground::on) {
                    // When the model is drawn again, the background's labels are not mixed across triangles
                    // at the seams.
                    EXPECT_LT(d.share_above_one, 1e-2) << "blend " << int(blend);
                    EXPECT_LE(d.share_above_24, 1e-3) << "blend " << int(blend);
                    continue;
                }
                // Rounding may decide which photo is best.
                EXPECT_LT(d.share_above_one, 2e-3) << "blend " << int(blend);
                if (blend != Blend::best) {
                    EXPECT_LE(d.share_above_24, 2e-5) << "blend " << int(blend);
                    if (gl::current_device().software) {
                        EXPECT_LE(largest_difference(renderer, view, by_pixel, by_model), 24)
                            << "blend " << int(blend);
                    }
                }
            }
}

TEST_F(Frames, ACoarseMeshInMotionLooksLikeTheMesh) {
    copy_scene(garden_spec(60000, 400, 300), dir / "fine");
    PrepareSettings prepared;
    prepared.effects[Effect::background] = EffectChoice::on;
    prepared.effects[Effect::per_fragment] = EffectChoice::on;
    const fs::path fine = made_package(dir / "fine", prepared);
    const PackageReader package(fine);
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    settings.photos = 4;
    settings.reduced = true;
    settings.fill_holes = true;
    const View view = scaled(view_of_photo(package.photos()[1], 0.8), 0.5);
    const Picture of_mesh = take_picture(renderer, view, settings, all(package), 1);
    renderer.planner().coarsen(true);
    const Picture coarse = take_picture(renderer, view, settings, all(package), 1);
    EXPECT_NE(coarse.rgba, of_mesh.rgba) << "the mesh should not have been drawn";
    double squares = 0;
    for (std::size_t i = 0; i < coarse.rgba.size(); ++i)
        squares += std::pow(int(coarse.rgba[i]) - int(of_mesh.rgba[i]), 2);
    EXPECT_GT(10 * std::log10(255 * 255 / (squares / double(coarse.rgba.size()))), 30);
    // The triangle at each pixel must belong to the mesh.
    const auto triangles = renderer.planner().seen().triangles();
    ASSERT_FALSE(triangles.empty());
    EXPECT_LE(std::ranges::max(triangles), renderer.scene().triangles);
    // At rest, the mesh is drawn again.
    settings.reduced = false;
    const Picture at_rest = take_picture(renderer, view, settings, all(package), 1);
    Renderer other(package, MemoryBudget{});
    EXPECT_EQ(at_rest.rgba, take_picture(other, view, settings, all(package), 1).rgba);
}

TEST_F(Frames, ASectionTakesAwayWhatIsBeforeIt) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    const View view = views(package).front();
    expect_cut(package, view, {{-view.cam_from_origin.direction(), 0}}, all(package));
}

TEST_F(Frames, OfABoxOnlyWhatIsInsideIsLeft) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    const Eigen::AlignedBox3d bounds = bounds_from_origin(package.scene());
    std::vector<SectionPlane> box;
    for (int i = 0; i < 3; ++i) {
        const double middle = bounds.center()[i], half = 0.3 * bounds.sizes()[i];
        box.push_back({-Eigen::Vector3d::Unit(i), -(middle - half)});
        box.push_back({Eigen::Vector3d::Unit(i), middle + half});
    }
    for (const View& view : views(package)) expect_cut(package, view, box, all(package));
}

TEST_F(Frames, SmallerThanTheirTargetsLookAsWithTargetsOfTheirOwn) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer own(package, MemoryBudget{}), roomy(package, MemoryBudget{});
    RenderSettings settings;
    settings.fill_holes = true;
    settings.plain_background = {{0.1f, 0.2f, 0.4f}, {0.4f, 0.3f, 0.2f}, 0.1};
    for (const View& view : views(package)) {
        RenderSettings large = settings;
        large.capacity = {view.intrinsics.width, view.intrinsics.height};
        // The previous, larger frame leaves its pixels next to those of the smaller frame.
        take_picture(roomy, view, large, all(package), 1);
        const View small = scaled(view, 0.37);
        EXPECT_EQ(take_picture(roomy, small, large, all(package), 2).rgba,
                  take_picture(own, small, settings, all(package), 2).rgba);
        EXPECT_EQ(roomy.resources().targets.allocated, large.capacity) << "no new targets";
    }
}

TEST_F(Frames, SmallerOnesAreShownEnlarged) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    ObjectSet objects(renderer, {{"scene", file, {}, true}}, MemoryBudget{});
    Enlargement enlargement;
    const View view = views(package).front();
    const FrameSize size{view.intrinsics.width, view.intrinsics.height};
    enlargement.fit(size);
    RenderSettings settings;
    settings.fill_holes = true;
    settings.capacity = size;
    const auto shown = [&](double scale) {
        const View drawn = scaled(view, scale);
        objects.draw(drawn, settings, all(package), {}, 0);
        return picture_of(size,
                          [&](GLuint target) { enlargement.show(objects, drawn, settings, size, {target}); });
    };
    const Picture whole = shown(1), half = shown(0.5), tiny = shown(0.1);
    const auto mean_off = [&](const Picture& p) {
        double sum = 0;
        for (std::size_t i = 0; i < p.rgba.size(); ++i) sum += std::abs(int(p.rgba[i]) - int(whole.rgba[i]));
        return sum / double(p.rgba.size());
    };
    EXPECT_GT(mean_off(half), 0);
    EXPECT_LT(mean_off(half), 8);
    EXPECT_LT(mean_off(half), mean_off(tiny));
    EXPECT_LT(mean_off(tiny), 30) << "the picture should be in the right position";
    // The last rows and columns must not show remains of larger frames from beyond the picture's edges.
    const auto edge_off = [&](const Picture& p) {
        double sum = 0;
        for (int x = 0; x < p.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto at = std::size_t(((p.height - 1) * p.width + x) * 4 + c);
                sum += std::abs(int(p.rgba[at]) - int(whole.rgba[at]));
            }
        return sum / (3.0 * p.width);
    };
    EXPECT_LT(edge_off(half), 12);
}

TEST_F(FramesAtLength, SamplesDrawnAtOnceGiveThePictureOfOneAfterTheOther) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    for (const View& large : views(package))
        for (const auto& [blend, transients] : {std::pair(Blend::lumigraph, false),
                                                {Blend::average, false},
                                                {Blend::best, false},
                                                {Blend::lumigraph, true}}) {
            const View view = scaled(large, 0.4);
            RenderSettings settings;
            settings.blend = blend;
            settings.transients = transients;
            settings.fill_holes = true;
            ASSERT_EQ(renderer.samples(view, settings, 2).size(), 1);
            const Picture at_once = take_picture(renderer, view, settings, all(package), 2);
            for (const PixelSample sample : single_samples(2))
                renderer.draw(view, settings, all(package), sample, 0);
            const Picture in_turn = shown_picture(renderer, view, settings);
            const Difference d = difference(at_once.rgba, in_turn.rgba);
            EXPECT_LT(d.share_above_one, 0.002) << "at most " << d.most;
            EXPECT_LT(d.share_above_24, 1e-4) << "at most " << d.most;
        }
}

TEST_F(Frames, SamplesAreDrawnOneByOneWhereTargetsWouldBeTooLarge) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer any(package, {}), small(package, {.graphics = std::uint64_t(64) << 20});
    const auto frames = [](const Renderer& renderer, int width, int height) {
        View view;
        view.intrinsics.width = width, view.intrinsics.height = height;
        return renderer.samples(view, {}, 2).size();
    };
    EXPECT_EQ(frames(any, 1000, 1000), 1u);
    EXPECT_EQ(frames(any, 3000, 1000), 4u);
    GLint longest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
    EXPECT_EQ(frames(any, longest / 2 + 1, 20), 4u) << "the frame can be drawn, but not at twice the size";
    EXPECT_EQ(frames(small, 1000, 1000), 4u) << "three quarters of graphics memory is reserved for tiles";
    EXPECT_EQ(frames(small, 100, 100), 1u);
}

TEST_F(Frames, PassesThatAreTimedTakeNoMoreThanTheFrames) {
    const gl::HeadlessContext context;
    const PackageReader package(file);
    Renderer renderer(package, {});
    const View view = views(package)[1];
    RenderSettings settings;
    settings.fill_holes = true;
    take_picture(renderer, view, settings, all(package), 1);
    glFinish();
    PassClock& clock = renderer.resources().pass_clock;
    EXPECT_EQ(clock.finish(), PassTimes()) << "passes should not be timed unless this is requested";
    PassTimes times{};
    const double all_ms = ms_of([&] {
        clock.start();
        for (int i = 0; i < 3; ++i) take_picture(renderer, view, settings, all(package), 1);
        times = clock.finish();
    });
    double sum = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto pass = TimedPass(i);
        const bool drawn = pass != TimedPass::points && pass != TimedPass::transparent;
        EXPECT_EQ(times.at(i) > 0, drawn) << timed_pass_names.at(i);
        sum += times.at(i);
    }
    EXPECT_LT(sum, all_ms);
    EXPECT_GT(sum, 0.1 * all_ms) << "in milliseconds";
}
