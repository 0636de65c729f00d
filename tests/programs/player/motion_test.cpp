// Tests frames in motion, whose plans are made on another thread: their allocations and their content.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <numbers>
#include <numeric>

#include "base/gl/context.h"
#include "player/render/picture.h"
#include "player/render/renderer.h"
#include "player/view/camera_path.h"
#include "player/view/navigation.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace {

thread_local std::size_t allocations = 0;  // by C++ code; the driver allocates in C

void* allocated(std::size_t bytes) {
    ++allocations;
    if (void* const memory = std::malloc(std::max<std::size_t>(bytes, 1))) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) { return allocated(bytes); }
void* operator new[](std::size_t bytes) { return allocated(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Motion : public TemporaryFolder {
  protected:
    static constexpr int width = 160, height = 120;
    fs::path file = dir / "scene.vantage";
    double now = 0;
    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(spec_named("tiny"), dir / "scene");
        copy_package(dir / "scene", {}, file);
    }
    static RenderSettings streamed() {
        RenderSettings s;
        s.loading = Loading::streamed;
        s.photos = 4;
        return s;
    }
    static std::vector<std::uint32_t> all(const PackageReader& package) {
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return photos;
    }
    /// Views on a close orbit around the model, which advance by this many degrees per frame.
    static std::vector<View> orbit(const PackageReader& package, int frames, double degrees) {
        Navigation from = home_of(package, 2);
        from.eye = from.target + 0.6 * (from.eye - from.target);
        std::vector<View> out;
        for (int i = 0; i < frames; ++i) {
            const Eigen::AngleAxisd turn(i * degrees * std::numbers::pi / 180, from.up.normalized());
            const Eigen::Vector3d eye = from.target + turn * (from.eye - from.target);
            out.push_back(view_towards(eye, from.target, from.up, 25, width, height));
        }
        return out;
    }
    /// Views that pan left and right from a position where the frame shows only a part of the model.
    static std::vector<View> pan(const PackageReader& package, int frames) {
        const Navigation from = home_of(package, 2);
        const Eigen::Vector3d ahead = from.target - from.eye, right = ahead.cross(from.up).normalized();
        std::vector<View> out;
        for (int i = 0; i < frames; ++i) {
            const double share = 0.25 * std::sin(0.4 * i);
            out.push_back(view_towards(from.eye, from.target + share * ahead.norm() * right, from.up, 12,
                                       width, height));
        }
        return out;
    }
    FrameReport draw(Renderer& renderer, const View& view, const std::vector<std::uint32_t>& photos) {
        return renderer.draw(view, streamed(), photos, {}, now += 1 / 30.0);
    }
};

/// The number of empty pixels.
std::size_t holes(const Picture& picture) {
    std::size_t n = 0;
    for (std::size_t at = 3; at < picture.rgba.size(); at += 4) n += picture.rgba[at] == 0;
    return n;
}

}  // namespace

TEST_F(Motion, FramesAllocateNothing) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer renderer(package, {});
    const std::vector<std::uint32_t> photos = all(package);
    const std::vector<View> views = orbit(package, 300, 0.1);
    for (int i = 0; i < 300; i += 3)
        draw(renderer, views[std::size_t(i)], photos);  // until everything is loaded
    std::vector<std::size_t> of_frames;
    for (const View& view : views) {
        const std::size_t before = allocations;
        draw(renderer, view, photos);
        of_frames.push_back(allocations - before);
    }
    // A frame that is late enough waits for its plan, and planning may be delayed on a busy machine.
    EXPECT_LE(std::ranges::count_if(of_frames, [](std::size_t n) { return n > 0; }), 15);
}

TEST_F(Motion, NoFrameLacksPhotosOnWhatComesIntoView) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer renderer(package, {}), other(package, {});
    const std::vector<std::uint32_t> photos = all(package);
    RenderSettings complete = streamed();
    complete.loading = Loading::complete;
    const std::vector<View> views = pan(package, 40);
    for (const View& view : views) take_picture(renderer, view, complete, photos, 1);
    for (int i = 0; i < 20; ++i) draw(renderer, views.front(), photos);
    for (const View& view : views) {
        draw(renderer, view, photos);
        const std::size_t in_motion = holes(shown_picture(renderer, view, streamed())),
                          at_rest = holes(take_picture(other, view, complete, photos, 1));
        EXPECT_LE(double(in_motion), double(at_rest) + 0.002 * width * height)
            << "view " << &view - views.data();
    }
}
