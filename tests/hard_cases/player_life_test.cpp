// Tests the player under adverse conditions: windows of all sizes, invalid paths, too little memory, no
// graphics, clock jumps, and a package that is truncated, overwritten or deleted.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <random>

#include "base/text/error.h"
#include "pipeline/prepare/repack_package.h"
#include "player/stream/layer_pool.h"
#include "player/view/camera_path.h"
#include "player/view/shots.h"
#include "prepared_scene.h"
#include "tests/one_line.h"
#include "tests/programs/run_program.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class PlayerLifetime : public PreparedScene {
  protected:
    RenderSettings streamed() const {
        RenderSettings s;
        s.loading = Loading::streamed;
        s.photos = 4;
        return s;
    }
    /// Draws a frame every thirtieth of a second, starting at `now`, until the picture has settled. Returns
    /// the report on the last frame, or nullopt if the picture never settles.
    std::optional<FrameReport> settle(Renderer& r, const View& view, const RenderSettings& s, double now,
                                      int frames = 300) {
        for (int i = 0; i < frames; ++i) {
            const FrameReport report = r.draw(view, s, photos, {}, now + i / 30.0);
            if (report.settled && report.photos > 0) return report;
            ::usleep(1000);  // gives the worker threads time
        }
        return std::nullopt;
    }
    std::vector<std::uint8_t> shown(Renderer& r, const View& view, const RenderSettings& s) const {
        const int w = view.intrinsics.width, h = view.intrinsics.height;
        const gl::Texture color = gl::make_texture_2d("picture", GL_RGBA8, w, h);
        const gl::Framebuffer target = gl::make_framebuffer("picture", std::array{color.id()}, 0);
        r.show(view, s, {target.id()});
        std::vector<std::uint8_t> rgba(std::size_t(w) * std::size_t(h) * 4);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(color.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(rgba.size()), rgba.data());
        return rgba;
    }

    struct Outcome {
        int code;
        std::string message;
    };
    Outcome play(const std::string& options, const std::string& environment = "") const {
        const fs::path message = dir / "message";
        const std::string command = "env " + environment + " " VANTAGE_PLAYER " " + with_file(options, file) +
                                    " >/dev/null 2>" + message.string();
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(message)};
    }

    /// Renders many views, and calls `happen` after the first picture has been written.
    template <class Happen>
    Outcome play_while(const Happen& happen) const {
        const fs::path path = dir / "many.path", message = dir / "message", out = dir / "pictures";
        {
            std::ofstream views(path);
            for (int i = 0; i < 40; ++i) views << "0 -12 " << 1 + 0.01 * i << "  0 0 1\n";
        }
        int ends[2];
        if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
        const pid_t child = ::fork();
        if (child == 0) {
            ::dup2(ends[1], STDOUT_FILENO);
            ::dup2(::open(message.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
            ::close(ends[0]);
            ::execl(VANTAGE_PLAYER, VANTAGE_PLAYER, "render", file.c_str(), "--size", "64x48", "--samples",
                    "1", "--path", path.c_str(), "-o", out.c_str(), nullptr);
            ::_exit(127);
        }
        ::close(ends[1]);
        char byte = 0;
        bool happened = false;
        while (::read(ends[0], &byte, 1) == 1)
            if (byte == '\n' && !happened) happened = (happen(), true);
        ::close(ends[0]);
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(happened) << slurp(message);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), slurp(message)};
    }
};

}  // namespace

TEST_F(PlayerLifetime, WindowResizedEveryFrame) {
    std::mt19937 random(1);
    Renderer fresh(*package, MemoryBudget{});
    for (int frame = 0; frame < 20; ++frame) {
        const int w = frame == 7 ? 1 : 1 + int(random() % 90), h = frame == 7 ? 1 : 1 + int(random() % 90);
        RenderSettings s = streamed();
        renderer->draw(between(0, 1, w, h), s, photos, {}, frame / 30.0);
        s.loading = Loading::complete;
        s.photos = 0;
        if (frame % 5 != 2) continue;
        EXPECT_EQ(picture(between(0, 1, w, h), s).rgba,
                  take_picture(fresh, between(0, 1, w, h), s, photos, 1).rgba)
            << w << 'x' << h << ", frame " << frame;
    }
}

TEST_F(PlayerLifetime, ComparesInWindowsOfAFewPixels) {
    for (const int width : {1, 2, 3, 5})
        for (const Compare compare :
             {Compare::nothing, Compare::side_by_side, Compare::swipe, Compare::difference}) {
            RenderSettings s;
            s.compare = compare;
            s.compare_photo = 2;
            const Picture p = picture(own_view(2, width / 331.0), s);
            ASSERT_EQ(p.width, width);
            EXPECT_TRUE(compare == Compare::nothing || p.rgba[3] == 255) << width << ' ' << int(compare);
        }
}

TEST_F(PlayerLifetime, WindowsUpToTheTextureLimit) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    RenderSettings s;
    s.thumbnails = true;
    for (const auto& [w, h] : {std::pair(int(most), 2), {2, int(most)}}) {
        View view = own_view(2, 1);
        view.intrinsics = {w, h, 300, 300, w / 2.0, h / 2.0};
        const Picture p = picture(view, s);
        const std::size_t middle = 4 * (std::size_t(h / 2) * std::size_t(w) + std::size_t(w / 2));
        EXPECT_EQ(p.rgba[middle + 3], 255) << w << 'x' << h;
    }
    for (const auto& [w, h] :
         {std::pair(int(most) + 1, 1), {1, int(most) + 1}, {0, 0}, {0, 0}, {0, 5}, {-3, 4}}) {
        View view = own_view(2, 1);
        view.intrinsics.width = w;
        view.intrinsics.height = h;
        try {
            renderer->draw(view, s, photos, {}, 0);
            ADD_FAILURE() << w << 'x' << h;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::usage);
            EXPECT_NE(std::string(e.what()).find("picture of"), std::string::npos) << e.what();
        }
    }
    Renderer fresh(*package, MemoryBudget{});  // minimized before the first frame
    View none = own_view(2, 1);
    none.intrinsics.width = none.intrinsics.height = 0;
    EXPECT_THROW(fresh.draw(none, s, photos, {}, 0), Error);
    EXPECT_GT(picture(own_view(2, 0.1), s).rgba.size(), 0u) << "keeps working afterwards";
}

TEST_F(PlayerLifetime, ViewsAndPathsKeepTheirRollAsText) {
    for (const char* text : {"1,-12,1,0.5,0,1,40,-30", "1,-12,1,0.5,0,1,40", "0,0,9,0,0,1,40,77"}) {
        const auto [view, distance] = parse_view_and_distance(text, *package, {64, 48});
        const Navigation n = stand_at(view, up_of(package->scene()), distance);
        EXPECT_TRUE(view_text(n, *package).ends_with(std::string(text).substr(std::string(text).find("40"))));
        write_path(dir / "rolled.path", std::vector{n}, *package);
        const View again = read_path((dir / "rolled.path").string(), *package, {64, 48}).front().view;
        EXPECT_LT((again.cam_from_origin.R - view.cam_from_origin.R).norm(), 1e-5) << text;
    }
    const auto turned = [&](const char* text) {
        return parse_view(text, *package, {64, 48}).cam_from_origin;
    };
    const Pose level = turned("0,-9,0,0,0,0,45"), clockwise = turned("0,-9,0,0,0,0,45,90");
    EXPECT_LT((clockwise.R.row(0) - level.R.row(1)).norm(), 1e-12)
        << "the right side of the picture should tilt down";
    EXPECT_LT((clockwise.center() - level.center()).norm(), 1e-9);
}

TEST_F(PlayerLifetime, InvalidPathsAndSizesAreReportedInOneLine) {
    const fs::path path = dir / "odd.path";
    for (const char* line :
         {"nan 0 0 1 1 1", "0 0 0 inf 1 1", "1e400 0 0 1 1 1", "0 0 0 0 0 0", "1e300 0 0 -1e300 0 0",
          "0 0 0 1 1 1 nan", "0 0 0 1 1 1 0", "0 0 0 1 1 1 180", "0 0 0 1 1 1 -45", "0 0 0 1 1",
          "0 0 0 1 1 1 45 361", "0 0 0 1 1 1 45 nan", "0 0 0 1 1 1 45 7 1", "a view", "0x", "\xff\xfe"}) {
        std::ofstream(path) << "# a path\n\n0 -12 1 0 0 1\n" << line << '\n';
        try {
            read_path(path.string(), *package, {64, 48});
            ADD_FAILURE() << line;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            EXPECT_TRUE(std::string(e.what()).starts_with(path.string() + ":4: ")) << e.what();
        }
    }
    for (const char* text : {"", "\n\n", "# nothing\n"}) {
        std::ofstream(path) << text;
        EXPECT_THROW(read_path(path.string(), *package, {64, 48}), Error);
    }
    std::ofstream(path) << "0 -12 1 0 0 1\n1e20 0 0 0 0 1\n";
    EXPECT_EQ(read_path(path.string(), *package, {64, 48}).size(), 2u);
    const Outcome far = play("render --size 64x48 --path " + path.string() + " -o " + dir.string());
    EXPECT_EQ(far.code, int(Exit::usage)) << "too far away for single precision";
    EXPECT_TRUE(one_line(far.message)) << far.message;
    const Outcome wide = play("render --photo 0002 --size 100000x2 -o " + (dir / "wide.png").string());
    EXPECT_EQ(wide.code, int(Exit::usage)) << wide.message;
    EXPECT_TRUE(one_line(wide.message) && wide.message.find("100000x2, expected") != std::string::npos)
        << wide.message;
}

TEST_F(PlayerLifetime, BudgetSmallerThanATileIsExceededAndStillWorks) {
    const View view = own_view(2, 0.3);
    for (const std::uint64_t bytes : {std::uint64_t(1), std::uint64_t(100'000), std::uint64_t(1) << 20}) {
        Renderer small(*package, {bytes, 1});
        const RenderSettings s = streamed();
        ASSERT_TRUE(settle(small, view, s, 0)) << bytes;
        EXPECT_GT(small.planner().graphics_budget(), bytes) << "the excess should be reported";
        EXPECT_LT(small.planner().graphics_budget(), std::uint64_t(64) << 20);
        EXPECT_GE(small.planner().graphics_budget(), small.held());
    }
    // With a ring buffer of one byte and an upload budget of one byte per frame, only one piece of data can
    // be uploaded at a time.
    Renderer slow(*package, {0, 1});
    RenderSettings s = streamed();
    for (const std::size_t budget : {std::size_t(1), std::size_t(256) << 10}) {
        s.upload_bytes = budget;
        ASSERT_TRUE(settle(slow, view, s, 10)) << budget;
    }
    const auto picture_then = shown(slow, view, s);
    RenderSettings usual = streamed();
    ASSERT_TRUE(settle(*renderer, view, usual, 10));
    EXPECT_EQ(picture_then, shown(*renderer, view, usual));
}

TEST_F(PlayerLifetime, ClockJumpsDoNotChangeThePicture) {
    const View view = own_view(2, 0.3);
    const RenderSettings s = streamed();
    ASSERT_TRUE(settle(*renderer, view, s, 0));
    const auto usual = shown(*renderer, view, s);
    for (const double now : {1e9, 1e15, -1e9}) {
        Renderer other(*package, MemoryBudget{});
        ASSERT_TRUE(settle(other, view, s, now)) << now;
        EXPECT_EQ(shown(other, view, s), usual) << now;
        // The clock is set back while all tiles are resident.
        ASSERT_TRUE(settle(other, view, s, 0)) << "after " << now;
        EXPECT_EQ(shown(other, view, s), usual) << "after " << now;
        // The clock is set back while tiles still have to be read.
        ASSERT_TRUE(settle(other, own_view(0, 0.3), s, 1)) << "after " << now;
    }
}

TEST(LayerPoolLifetime, FrameCounterMayWrapAround) {
    constexpr std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
    LayerPool pool(2, 5);
    ASSERT_TRUE(pool.place(0, last - 1) && pool.place(1, last - 1));
    EXPECT_FALSE(pool.place(2, last - 1)) << "both layers should be in use";
    EXPECT_EQ(pool.available(last), 2u);
    ASSERT_TRUE(pool.place(2, last));
    EXPECT_FALSE(pool.layer_of(0).has_value()) << "the older page should have been evicted";
    ASSERT_TRUE(pool.place(3, 0)) << "the counter should wrap around";
    EXPECT_FALSE(pool.layer_of(1).has_value());
    EXPECT_TRUE(pool.layer_of(2) && pool.layer_of(3));
}

TEST_F(PlayerLifetime, TruncatingTheOpenPackageIsReported) {
    // The tiles are raw, because the compact tiles of such a small scene would already be in memory.
    repack(file, false, dir / "raw.vantage");
    fs::rename(dir / "raw.vantage", file);
    const Outcome cut = play_while([&] { fs::resize_file(file, 4096); });
    EXPECT_EQ(cut.code, int(Exit::damaged)) << cut.message;
    EXPECT_TRUE(one_line(cut.message)) << cut.message;
    EXPECT_TRUE(cut.message.starts_with("vantage-player: " + file.string() + ": can no longer be read"))
        << cut.message;
}

TEST_F(PlayerLifetime, DeletingTheOpenPackageChangesNothing) {
    const Outcome gone = play_while([&] { fs::remove(file); });
    EXPECT_EQ(gone.code, 0) << gone.message;
    EXPECT_TRUE(gone.message.empty()) << gone.message;
    EXPECT_TRUE(fs::exists(dir / "pictures" / "0039.png"));
}

TEST_F(PlayerLifetime, OverwrittenTilesAreSkippedUntilRestored) {
    const View view = own_view(2, 0.5);
    const RenderSettings s = streamed();
    ASSERT_TRUE(settle(*renderer, own_view(0, 0.1), s, 0));
    const std::string valid = slurp(file);
    const auto overwrite = [&](const std::string& bytes) {
        std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
            .write(bytes.data(), std::streamsize(bytes.size()));
    };
    std::mt19937 random(5);
    for (int round = 0; round < 3; ++round) {
        std::string noise(valid.size(), 0);
        for (char& c : noise) c = char(random());
        overwrite(round == 2 ? std::string(valid.size(), '\xff') : noise);
        for (int i = 0; i < 30; ++i)
            renderer->draw(own_view(std::uint32_t(i) % 5, 0.5), s, photos, {}, round + i / 30.0);
    }
    overwrite(valid);
    ASSERT_TRUE(settle(*renderer, view, s, 20));
    const auto report = settle(*renderer, view, s, 40);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->tiles_damaged, 0u);
    Renderer fresh(*package, MemoryBudget{});
    ASSERT_TRUE(settle(fresh, view, s, 0));
    EXPECT_EQ(shown(*renderer, view, s), shown(fresh, view, s));
}

TEST_F(PlayerLifetime, MissingOpenGlIsReportedInOneLine) {
    const std::string none =
        "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent/egl.json "
        "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent LIBGL_DRIVERS_PATH=/nonexistent";
    for (const std::string& options : {"render --photo 0002 -o " + (dir / "a.png").string(),
                                       "render --view 0,-12,1,0,0,1 -o " + (dir / "b.png").string()}) {
        const Outcome outcome = play(options, none);
        EXPECT_EQ(outcome.code, int(Exit::graphics)) << outcome.message;
        EXPECT_TRUE(one_line(outcome.message)) << outcome.message;
        EXPECT_NE(outcome.message.find("OpenGL 4.5"), std::string::npos) << outcome.message;
    }
    const Outcome window = play("--no-saved-settings --frames 1", "-u DISPLAY -u WAYLAND_DISPLAY " + none);
    EXPECT_EQ(window.code, int(Exit::graphics)) << window.message;
    EXPECT_TRUE(one_line(window.message)) << window.message;
    EXPECT_EQ(play("list", none).code, 0) << "list should need no graphics";
}
