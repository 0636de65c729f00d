// Tests streaming in the player: fetched bytes must match the package, budgets must be kept, and damaged
// tiles must never be shown. Also tests the coverage of plans.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <numeric>
#include <set>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/values/tiling.h"
#include "player/options/tiles_not_shown.h"
#include "player/render/picture.h"
#include "player/render/renderer.h"
#include "player/render/timing/pace.h"
#include "player/view/camera_path.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Streaming : public TemporaryFolder {
  protected:
    fs::path file = dir / "scene.vantage";
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        spec.photos.width = 1200;
        spec.photos.height = 900;
        spec.photos.samples = 1;
        copy_scene(spec, dir / "scene");
        copy_package(dir / "scene", {}, file);
    }
    static std::vector<std::uint32_t> all(const PackageReader& package) {
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return photos;
    }
    static RenderSettings streamed() {
        RenderSettings s;
        s.loading = Loading::streamed;
        s.photos = 4;
        return s;
    }
};

double mean_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(int(a[i]) - int(b[i]));
    return sum / double(a.size());
}

}  // namespace

TEST_F(Streaming, FetchedBytesMatchThePackage) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    const PackagePages pages = number_pages(package.photos());
    for (const std::size_t ring : {4 * tile_bytes, 9 * tile_bytes + 777}) {
        TileStream stream(package, ring, 3);
        std::vector<StreamRequest> wanted;
        for (std::uint32_t t = 0; t < 20; ++t) wanted.push_back(color_request(package, pages, 1, 0, t));
        for (std::uint32_t t = 0; t < 6; ++t) wanted.push_back(weight_map_request(package, pages, 2, 1, t));
        wanted.push_back(thumbnail_request(package, 3));
        stream.want(wanted);
        std::set<std::uint64_t> arrived;
        while (stream.wait()) {
            while (const auto f = stream.take(SIZE_MAX)) {
                std::vector<std::byte> bytes(f->bytes());
                glGetNamedBufferSubData(stream.buffer(), GLintptr(f->piece->offset), GLsizeiptr(bytes.size()),
                                        bytes.data());
                const StreamRequest& r = f->request;
                EXPECT_EQ(f->state, Fetched::State::valid);
                std::vector<std::byte> expected(bytes.size());
                if (r.resource == Resource::thumbnail) {
                    EXPECT_TRUE(read_thumbnail(package, r.key, expected));
                } else {
                    std::size_t at = 0;
                    for (const auto* chunk : {r.chunk, r.second}) {
                        if (!chunk) continue;
                        const package::PhotoRecord& p = package.photos()[chunk->photo];
                        const Level level = level_size(int(p.width), int(p.height), int(chunk->level));
                        EXPECT_TRUE(read_tile(package, *chunk, level, r.block,
                                              std::span(expected).subspan(at, tile_bytes)));
                        at += tile_bytes;
                    }
                }
                EXPECT_TRUE(bytes == expected);
                EXPECT_TRUE(arrived.insert(r.identity()).second) << "fetched twice";
                stream.release(*f);
            }
            stream.fence();
        }
        EXPECT_EQ(arrived.size(), wanted.size());
        EXPECT_EQ(stream.waiting(), 0u);
    }
}

TEST_F(Streaming, UploadBudgetIsKeptAndThePictureConverges) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    const View view = view_of_photo(package.photos()[2], 0.5);
    RenderSettings settings = streamed();
    settings.upload_bytes = std::size_t(1) << 20;
    FrameReport report;
    std::vector<std::uint8_t> first;
    for (int frame = 0; frame < 400 && !report.settled; ++frame) {
        report = renderer.draw(view, settings, all(package), {}, frame / 30.0);
        ASSERT_LE(report.uploaded, settings.upload_bytes);
        // On a busy machine, thumbnails of some photos arrive several frames before those of others.
        const bool all_shown =
            report.photos > 0 && report.photos >= renderer.planner().frame().plan().photos.size();
        if (first.empty() && all_shown) first = shown_picture(renderer, view, settings).rgba;
    }
    ASSERT_TRUE(report.settled);
    const auto last = shown_picture(renderer, view, settings).rgba;
    settings.loading = Loading::complete;
    renderer.draw(view, settings, all(package), {}, 100);
    const auto exact = shown_picture(renderer, view, settings).rgba;
    EXPECT_LT(mean_difference(first, exact), 12) << "base levels should show the scene, although blurred";
    EXPECT_GT(mean_difference(first, exact), 0.2);
    EXPECT_LT(mean_difference(last, exact), 0.1);
}

TEST_F(Streaming, AFullFrameThatWaitsIsCompleteRightAfterReducedFrames) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    const View view = view_of_photo(package.photos()[2], 0.5);
    RenderSettings settings = streamed();
    settings.upload_bytes = std::size_t(1) << 28;
    settings.reduced = true;
    settings.loading = Loading::beginning;
    double now = 0;
    const auto draw = [&](const View& v, PixelSample sample) {
        return renderer.draw(v, settings, all(package), sample, now += 0.03);
    };
    for (int frame = 0; frame < 3; ++frame) {
        draw(scaled(view, 0.25), {});
        settings.loading = Loading::streamed;
    }
    settings.reduced = false;
    settings.loading = Loading::uploading;
    const FrameReport first = draw(view, {0, 2}), second = draw(view, {3, 2});
    EXPECT_TRUE(first.settled && second.settled);
    EXPECT_GT(first.uploaded, 0u);
    EXPECT_EQ(second.uploaded, 0u) << "the first sample lacked tiles";
}

TEST_F(Streaming, GraphicsMemoryStaysWithinItsBudget) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    const MemoryBudget budget{std::uint64_t(36) << 20, std::uint64_t(4) << 20};
    Renderer renderer(package, budget);
    const CameraPath path = scripted_path("flight", stand_at(package.photos()[2], {0, 0, 1}), 60);
    for (int frame = 0; frame < 60; ++frame) {
        const FrameReport report = renderer.draw(view_of(path.frames[std::size_t(frame)], 400, 300),
                                                 streamed(), all(package), {}, frame / 30.0);
        ASSERT_LE(gl::memory_held(), budget.graphics);
        ASSERT_EQ(report.tiles_damaged, 0u);
    }
}

TEST_F(Streaming, LimitThatAFrameCannotKeepIsExceededAndSaid) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    const std::uint64_t limit = std::uint64_t(8) << 20;
    Renderer renderer(package, {limit, std::uint64_t(1) << 20});
    const View view = view_of(stand_at(package.photos()[2], {0, 0, 1}), 400, 300);
    FrameReport report;
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; !report.settled && std::chrono::steady_clock::now() - start < std::chrono::minutes(1);
         ++frame) {
        report = renderer.draw(view, streamed(), all(package), {}, frame / 30.0);
        ASSERT_GT(renderer.planner().graphics_budget(), limit);
        ASSERT_LE(gl::memory_held(), renderer.planner().graphics_budget());
    }
    EXPECT_TRUE(report.settled);
    EXPECT_GT(report.photos, 0u);
}

TEST_F(Streaming, DamagedTilesFallBackToCoarserOnesUntilRestored) {
    const PackageReader package(file);
    const auto* tiles = package.find(package::Type::tiles, 2, 0);
    const auto invert_tiles = [&] {
        std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
        for (std::size_t t = 0; t < package.blocks(*tiles); ++t) {
            const auto block = package.block(*tiles, t);
            const auto at = std::streamoff(tiles->offset) + (block.data() - package.raw(*tiles).data()) +
                            std::streamoff(block.size() / 2);
            f.seekg(at);
            const int byte = f.get();
            f.seekp(at);
            f.put(char(~byte));
        }
    };
    invert_tiles();
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    const std::vector<std::uint32_t> only{2};
    const View view = view_of_photo(package.photos()[2], 1);
    const RenderSettings settings = streamed();
    double now = 0;
    const auto settle = [&] {
        FrameReport report;
        for (int frame = 0; frame < 200 && !report.settled; ++frame, now += 1 / 30.0)
            report = renderer.draw(view, settings, only, {}, now);
        EXPECT_TRUE(report.settled);
        return report;
    };
    EXPECT_GT(settle().tiles_damaged, 0u);
    const auto coarse = shown_picture(renderer, view, settings).rgba;
    std::size_t colored = 0;
    for (std::size_t i = 3; i < coarse.size(); i += 4) colored += coarse[i] == 255;
    EXPECT_GT(colored, coarse.size() / 4 / 3) << "coarser levels should be shown instead";
    now += 6;
    EXPECT_GT(settle().tiles_damaged, 0u) << "the tile should still be damaged on the second attempt";
    EXPECT_EQ(shown_picture(renderer, view, settings).rgba, coarse);
    invert_tiles();
    now += 6;
    settle();
    now += 11;  // requests in flight at the restoration and obsolete ones expire
    EXPECT_EQ(settle().tiles_damaged, 0u);
    Renderer fresh(package, {});
    fresh.draw(view, settings, only, {}, 0);
    RenderSettings complete = settings;
    complete.loading = Loading::complete;
    fresh.draw(view, complete, only, {}, 1);
    EXPECT_LT(mean_difference(shown_picture(renderer, view, settings).rgba,
                              shown_picture(fresh, view, complete).rgba),
              0.1);
}

TEST_F(Streaming, PicturesReadTheTilesThatTheyShow) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    const package::PhotoRecord& photo = package.photos()[2];
    const auto tiles_of_level = [&](int level) {
        return std::size_t(level_size(int(photo.width), int(photo.height), level).tiles());
    };
    // Each of the photo's tiles is used at most twice: for the mesh and for the background.
    FrameReport report = take_picture(renderer, view_of_photo(photo, 1), {}, all(package), 1).report;
    EXPECT_EQ(report.tiles_missing, 0u);
    EXPECT_LE(report.tiles, 2 * (tiles_of_level(0) + tiles_of_level(1)));
    // At an eighth of the size, the two finest levels of a photo are never shown.
    report = take_picture(renderer, view_of_photo(photo, 0.125), {}, all(package), 1).report;
    EXPECT_EQ(report.tiles_missing, 0u);
    EXPECT_GT(report.tiles, 0u);
    const Plan& plan = renderer.planner().frame().plan();
    for (const std::vector<PlannedPhoto>* photos : {&plan.photos, &plan.behind})
        for (const PlannedPhoto& p : *photos)
            EXPECT_EQ(p.needs.color[0].size() + p.needs.color[1].size(), 0u) << "photo " << p.photo;
}

TEST_F(Streaming, AtAPhotosCameraOthersShowWhatIsBesideIt) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    const auto colored = [&](const View& view) {
        const Picture picture = take_picture(renderer, view, {}, all(package), 1);
        std::size_t n = 0;
        for (std::size_t at = 3; at < picture.rgba.size(); at += 4) n += picture.rgba[at] > 0;
        return double(n);
    };
    for (const package::PhotoRecord& photo : package.photos()) {
        View wide = view_of_photo(photo, 0.25);
        wide.intrinsics.fx *= 0.5, wide.intrinsics.fy *= 0.5;
        View beside = wide;  // where no photo has the viewer's position
        beside.cam_from_origin.t += Eigen::Vector3d(1e-3, 0, 0);
        EXPECT_NEAR(colored(wide) / colored(beside), 1, 2e-3) << photo.name;
    }
}

TEST_F(Streaming, APictureThatLacksTilesIsIncomplete) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    const View view = view_of_photo(package.photos()[2], 1);
    const auto exit_with = [&](std::uint64_t graphics) {
        Renderer renderer(package, {graphics, std::uint64_t(1) << 20});
        TilesNotShown lacking;
        lacking.add(take_picture(renderer, view, {}, all(package), 1).report);
        return exit_for(package, lacking);
    };
    EXPECT_EQ(exit_with(std::uint64_t(1) << 20), int(Exit::incomplete)) << "16 tiles fit";
    EXPECT_EQ(exit_with(0), int(Exit::ok));
}

TEST_F(Streaming, APictureOfASmallModelComesToRest) {
    const PackageReader package(file);
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(package, {});
    RenderSettings settings = streamed();
    settings.photos = 1;
    settings.loading = Loading::repeatable;
    for (const double away : {100.0, 1000.0}) {
        const View view = view_towards({0.3 * away, -away, 0.2 * away}, {0, 0, 0}, {0, 0, 1}, 40, 640, 480);
        // Draw as in a window: each frame adds a sample once the picture has settled; any change restarts
        // sampling.
        constexpr int side = 4;
        int samples = 0, frame = 0;
        bool settled = false;
        for (; frame < 150 && samples < side * side; ++frame) {
            const PixelSample sample = settled ? PixelSample{samples, side} : PixelSample{};
            const bool rests = settled;
            settled = renderer.draw(view, settings, all(package), sample, away + frame / 30.0).settled;
            samples = rests && settled ? samples + 1 : 0;
            glFinish();  // visibility results arrive before the next frame
        }
        EXPECT_EQ(samples, side * side) << "from " << away;
    }
}

TEST_F(Streaming, PlansCoverTheViewAndKeepTheirPhotos) {
    const PackageReader package(file);
    const PlanScene scene = make_plan_scene(package);
    const auto photos = all(package);
    PlanSettings settings;
    settings.photos = 1;
    settings.sharpness = RenderSettings{}.weights.sharpness;
    const Navigation start = stand_at(package.photos()[2], {0, 0, 1});
    std::vector<std::uint32_t> previous;
    int changes = 0;
    for (const Navigation& n : scripted_path("orbit", start, 120).frames) {
        const Plan plan = make_plan(scene, view_of(n, 640, 480), settings, photos, {.previous = previous});
        EXPECT_LE(plan.uncovered, 1.6e-3) << "cover() guarantees this";
        EXPECT_EQ(plan.photos.size(), std::set<std::uint32_t>([&] {
                                          std::set<std::uint32_t> s;
                                          for (const auto& p : plan.photos) s.insert(p.photo);
                                          return s;
                                      }())
                                          .size());
        std::vector<std::uint32_t> now;
        for (const PlannedPhoto& p : plan.photos) now.push_back(p.photo);
        std::ranges::sort(now);
        changes += now != previous;
        previous = now;
        const Plan same = make_plan(scene, view_of(n, 640, 480), settings, photos, {.previous = previous});
        std::vector<std::uint32_t> again;
        for (const PlannedPhoto& p : same.photos) again.push_back(p.photo);
        std::ranges::sort(again);
        EXPECT_EQ(again, now) << "an unchanged view should keep its photos";
    }
    EXPECT_LT(changes, 40);
}
