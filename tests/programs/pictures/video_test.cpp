// Tests the videos of vantage-player: turntables, paths and tours, written as frames and through ffmpeg.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "base/text/error.h"
#include "player/render/picture.h"
#include "player/view/view.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/run_program.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Video : public TemporaryFolder {
  protected:
    const fs::path file = dir / "scene.vantage";
    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(spec_named("tiny"), dir / "scene");
        copy_package(dir / "scene", {}, file);
    }
    Outcome play(const std::string& options, const std::string& before = "") const {
        const bool sized = options.find("--size") != options.npos;
        return run_command("cd " + dir.string() + " && " + before + " " VANTAGE_PLAYER " " +
                               with_file(options, file) + (sized ? "" : " --size 96x64"),
                           dir);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(dir / name, std::ios::binary) << text;
    }
    /// An environment in which a script named `ffmpeg` comes first in PATH.
    std::string with_ffmpeg(const std::string& script) const {
        fs::create_directories(dir / "bin");
        write("bin/ffmpeg", "#!/bin/sh\n" + script);
        fs::permissions(dir / "bin/ffmpeg", fs::perms::owner_all);
        return "PATH=" + (dir / "bin").string() + ":$PATH";
    }
    std::set<std::string> files_in(const fs::path& folder) const {
        std::set<std::string> out;
        for (const auto& e : fs::directory_iterator(folder)) out.insert(e.path().filename().string());
        return out;
    }
    /// The view from `eye` toward `target`, relative to the origin, as a command-line option.
    std::string view_option(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, int fov = 40) const {
        const PackageReader reader(file);
        const Eigen::Map<const Eigen::Vector3d> origin(reader.scene().origin);
        std::ostringstream out;
        out << std::setprecision(17);
        for (const Eigen::Vector3d& p : {eye, target})
            for (int i = 0; i < 3; ++i) out << p[i] + origin[i] << ',';
        return out.str() + std::to_string(fov);
    }
};

/// The mean squared difference over all values.
double difference(const Picture& a, const Picture& b) {
    if (a.rgba.size() != b.rgba.size()) return HUGE_VAL;
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(double(a.rgba[i]) - double(b.rgba[i]), 2);
    return sum / double(a.rgba.size());
}

/// The fraction of the picture that differs from its most common color.
double detail(const Picture& a) {
    std::map<std::uint32_t, int> colors;
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        most = std::max(most, ++colors[std::uint32_t(a.rgba[i] << 16 | a.rgba[i + 1] << 8 | a.rgba[i + 2])]);
    return 1 - 4.0 * most / double(a.rgba.size());
}

}  // namespace

TEST_F(Video, TurntableGoesAroundTheTargetAndIsTheSameEachTime) {
    const PackageReader reader(file);
    const Eigen::Vector3d up = up_of(reader.scene()), eye(5, -9, 3), target(0.5, 0, 0);
    const std::string turn =
        "video --turntable --seconds 0.4 --frame-rate 10 --view " + view_option(eye, target);
    const Outcome made = play(turn + " -o frames");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(one_line(made.out)) << made.out;
    EXPECT_EQ(files_in(dir / "frames"), (std::set<std::string>{"scene-0001.png", "scene-0002.png",
                                                               "scene-0003.png", "scene-0004.png"}));
    for (const int frame : {0, 2}) {
        const Eigen::Vector3d there =
            target + Eigen::AngleAxisd(frame * std::numbers::pi / 2, up) * (eye - target);
        ASSERT_EQ(play("render --holes shade -o still.png --view " + view_option(there, target)).code, 0);
        const Picture still = read_png(dir / "still.png");
        const Picture moving = read_png(dir / "frames" / ("scene-000" + std::to_string(frame + 1) + ".png"));
        EXPECT_LT(difference(still, moving), 1) << frame;
        EXPECT_GT(detail(moving), 0.1) << frame;
    }
    ASSERT_EQ(play(turn + " -o again").code, 0);
    for (const std::string& name : files_in(dir / "frames"))
        EXPECT_TRUE(slurp(dir / "frames" / name) == slurp(dir / "again" / name)) << name;
}

TEST_F(Video, TurntableFramesTheWholeModel) {
    for (const std::string size : {"96x64", "48x128"}) {
        const Outcome made = play(
            "video --turntable --seconds 0.3 --frame-rate 10 --holes transparent --background "
            "off -o whole --size " +
            size);
        ASSERT_EQ(made.code, 0) << made.err;
        for (const std::string& name : files_in(dir / "whole")) {
            const Picture p = read_png(dir / "whole" / name);
            int seen = 0;
            for (int y = 0; y < p.height; ++y)
                for (int x = 0; x < p.width; ++x) {
                    const bool shown = p.rgba[4 * std::size_t(y * p.width + x) + 3] > 0;
                    seen += shown;
                    const bool edge = x == 0 || y == 0 || x == p.width - 1 || y == p.height - 1;
                    EXPECT_FALSE(shown && edge) << name << ' ' << size << ": cut at " << x << ' ' << y;
                }
            if (name == "scene-0001.png") {
                EXPECT_GT(seen, p.width * p.height / 20) << size;  // from the photos' side
            }
        }
    }
}

TEST_F(Video, PathMeetsItsViewsAtTheirTimes) {
    const std::string first = view_option({5, -9, 3}, {0, 0, 0}),
                      second = view_option({-4, -9, 2}, {0, 0, 1}),
                      last = view_option({0, -12, 2}, {0, 0, 0});
    write("way.path", "# a comment\n" + first + " at=1\n" + second + " at=1.5\n" + last + " at=2\n");
    ASSERT_EQ(play("video --path way.path --frame-rate 8 -o frames").code, 0);
    EXPECT_EQ(files_in(dir / "frames").size(), 9u) << "one second at 8 frames per second, and the last view";
    ASSERT_EQ(play("render --path way.path --holes shade -o stills").code, 0);
    for (const auto& [still, frame] : {std::pair("0000", "0001"), {"0001", "0005"}, {"0002", "0009"}}) {
        const Picture a = read_png(dir / "stills" / (std::string(still) + ".png")),
                      b = read_png(dir / "frames" / ("scene-" + std::string(frame) + ".png"));
        EXPECT_LT(difference(a, b), 1) << still;
        EXPECT_GT(detail(b), 0.1) << still;
    }
    write("wrong.path", first + " at=2\n" + second + " at=1\n");
    const Outcome wrong = play("video --path wrong.path -o frames");
    EXPECT_EQ(wrong.code, int(Exit::input));
    EXPECT_NE(wrong.err.find("wrong.path:2: "), std::string::npos) << wrong.err;
    write("mixed.path", first + " at=2\n" + second + "\n");
    EXPECT_EQ(play("video --path mixed.path -o frames").code, int(Exit::input));
}

TEST_F(Video, TourOfTheStoryStaysAtItsStops) {
    const PackageReader reader(file);
    const double* o = reader.scene().origin;
    std::ostringstream story;
    story
        << std::setprecision(17) << R"({"format": "vantage-story-1", "notes": [{"id": "n", "view": {"eye": [)"
        << o[0] + 5 << ',' << o[1] - 9 << ',' << o[2] + 3 << R"(], "target": [)" << o[0] << ',' << o[1] << ','
        << o[2]
        << R"(], "fov": 40}}], "tours": [{"id": "short", "title": {"de": "Kurz"}, "stops": [{"note": "n", "stay": 0.5}]}]})";
    write("scene.story.json", story.str());
    ASSERT_EQ(play("video --tour Kurz --frame-rate 4 -o frames").code, 0);
    EXPECT_EQ(files_in(dir / "frames").size(), 3u);
    EXPECT_TRUE(slurp(dir / "frames/scene-0001.png") == slurp(dir / "frames/scene-0003.png"))
        << "the camera should not move";
    ASSERT_EQ(play("render --holes shade -o still.png --view " + view_option({5, -9, 3}, {0, 0, 0})).code, 0);
    EXPECT_LT(difference(read_png(dir / "still.png"), read_png(dir / "frames/scene-0001.png")), 1);
    const Outcome none = play("video --tour long -o frames");
    EXPECT_EQ(none.code, int(Exit::usage));
    EXPECT_NE(none.err.find("expected short"), std::string::npos) << none.err;
}

TEST_F(Video, BackgroundOfTheStoryIsBehindTheModel) {
    const auto corners = [&](const std::string& plain_background, const std::string& options = "") {
        write("scene.story.json", R"({"format": "vantage-story-1", "background": )" + plain_background + "}");
        const Outcome made =
            play("video --turntable --seconds 0.1 --frame-rate 10 --background off -o frames " + options);
        EXPECT_EQ(made.code, 0) << made.err;
        const Picture p = read_png(dir / "frames/scene-0001.png");
        std::vector<std::array<int, 3>> out;
        for (const int y : {0, p.height / 2, p.height - 1}) {
            const std::size_t at = 4 * std::size_t(y * p.width);
            out.push_back({p.rgba[at], p.rgba[at + 1], p.rgba[at + 2]});
        }
        return out;
    };
    EXPECT_EQ(corners(R"({"color": "#204060"})"), (std::vector<std::array<int, 3>>(3, {0x20, 0x40, 0x60})));
    const auto gradient = corners(R"({"top": "#ff0000", "bottom": "#0000ff"})");
    EXPECT_GT(gradient[0][0], 250);
    EXPECT_LT(gradient[0][2], 40);
    EXPECT_NEAR(gradient[1][0], gradient[1][2], 8) << "there should be as much red as blue in the middle";
    EXPECT_GT(gradient[2][2], 250);
    // The facade fills the frame; only at its edges does it fade into the background.
    const std::string close = "--view " + view_option({0, -20, 1}, {0, 0, 1}, 6);
    const auto hard = corners(R"({"color": "#00ff00"})", close);
    const auto soft = corners(R"({"color": "#00ff00", "soft_edges": 0.2})", close);
    EXPECT_NE(hard[1], (std::array<int, 3>{0, 255, 0}));
    EXPECT_LT(soft[1][0], 20);
    EXPECT_GT(soft[1][1], 235);
}

TEST_F(Video, FfmpegGetsEveryFrameAndTheFileItsNameAtTheEnd) {
    const std::string path =
        with_ffmpeg("for last; do :; done\necho \"$@\" >arguments\nwc -c >\"${last#file:}\"\nls >listing\n");
    write("clip.mp4", std::string("\0\0\0\x18"
                                  "ftypisom",
                                  12));
    const Outcome made = play("video --turntable --seconds 0.5 --frame-rate 12.5 -o clip.mp4", path);
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(std::stoi(slurp(dir / "clip.mp4")), 6 * 96 * 64 * 4);
    const std::string arguments = slurp(dir / "arguments");
    for (const char* part :
         {"-video_size 96x64", "-framerate 12.5", "-pixel_format rgba", "libx264", "yuv420p"})
        EXPECT_NE(arguments.find(part), std::string::npos) << part << " is not in " << arguments;
    EXPECT_NE(slurp(dir / "listing").find("clip.mp4.part-"), std::string::npos) << slurp(dir / "listing");
    ASSERT_EQ(play("video --turntable --seconds 0.1 --holes transparent -o clip.webm", path).code, 0);
    EXPECT_NE(slurp(dir / "arguments").find("yuva420p"), std::string::npos);
}

TEST_F(Video, WhatFailsIsOneLineAndLeavesNothing) {
    const std::set<std::string> before = files_in(dir);
    const auto expect = [&](const Outcome& o, Exit code, const char* says, const char* what) {
        EXPECT_EQ(o.code, int(code)) << what << ": " << o.err;
        EXPECT_TRUE(one_line(o.err)) << what << ": " << o.err;
        EXPECT_NE(o.err.find(says), std::string::npos) << what << ": " << o.err;
        std::set<std::string> now = files_in(dir);
        for (const char* own : {"bin", "out.txt", "err.txt", "notes.mp4"}) now.erase(own);
        EXPECT_EQ(now, before) << what;
    };
    const std::string clip = "video -q --turntable --seconds 0.5 -o clip.mp4";
    expect(play(clip, with_ffmpeg("echo first >&2; echo 'Unknown encoder libx264' >&2; exit 1\n")),
           Exit::storage, "clip.mp4: ffmpeg failed: Unknown encoder libx264", "an encoder that is missing");
    expect(play(clip, with_ffmpeg(
                          "for last; do :; done\nhead -c 1000 >\"${last#file:}\"\necho full >&2; exit 1\n")),
           Exit::storage, "full", "a full disk");
    expect(play(clip, with_ffmpeg("cat >/dev/null; kill -9 $$\n")), Exit::storage, "without a message",
           "a crash");
    fs::remove_all(dir / "bin");
    fs::create_directories(dir / "bin");
    for (const char* tool : {"env", "sh"}) fs::create_symlink(fs::path("/bin") / tool, dir / "bin" / tool);
    expect(play(clip, "PATH=" + (dir / "bin").string()), Exit::input, "installed", "no ffmpeg");
    const std::string swallow = with_ffmpeg("for last; do :; done\ncat >\"${last#file:}\"\n");
    // Presses Ctrl+C once ffmpeg is running.
    const std::string interrupt =
        "sh -c '\"$@\" & until ls clip.mp4.part-* >/dev/null 2>&1; do sleep 0.1; done; "
        "kill -INT $!; wait $!' sh";
    expect(play("video -q --turntable --seconds 60 -o clip.mp4", swallow + " " + interrupt),
           Exit::interrupted, "interrupted", "Ctrl+C");
    expect(play("video --turntable --size 95x64 -o clip.mp4", swallow), Exit::usage, "even width",
           "an odd width");
    expect(play("video --turntable --holes transparent -o clip.mp4", swallow), Exit::usage, "webm",
           "transparent MP4");
    expect(play("video --turntable"), Exit::usage, "-o", "no output");
    expect(play("video --turntable --tour a -o frames"), Exit::usage, "one of", "two ways");
    expect(play("video --turntable --seconds 99999 --frame-rate 240 -o frames"), Exit::usage, "million",
           "too long");
    write("notes.mp4", "mine");
    expect(play("video --turntable -o notes.mp4", swallow), Exit::usage, "is not an MP4", "another file");
    EXPECT_EQ(slurp(dir / "notes.mp4"), "mine");
}

TEST_F(Video, IsPlayableAndLooksLikeItsFrames) {
    if (std::system("command -v ffmpeg ffprobe >/dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed";
    const std::string turn = "video --turntable --seconds 0.5 --frame-rate 10 --size 160x96 -o ";
    ASSERT_EQ(play(turn + "frames").code, 0);
    for (const std::string name : {"-clip.mp4", "a:b.webm"}) {
        const Outcome made = play(turn + "./" + name);
        ASSERT_EQ(made.code, 0) << made.err;
        ASSERT_EQ(std::system(("cd " + dir.string() +
                               " && ffprobe -v error -count_frames -show_entries "
                               "stream=nb_read_frames,width,height,avg_frame_rate -of csv=p=0 file:" +
                               name + " >probe 2>&1; ffmpeg -y -v error -i file:" + name +
                               " -frames:v 1 decoded.png")
                                  .c_str()),
                  0);
        EXPECT_GT(10 * std::log10(255 * 255 /
                                  difference(read_png(dir / "decoded.png"),
                                             read_png(dir / "frames/scene-0001.png"))),
                  28)  // chroma has half the resolution
            << name;
    }
    EXPECT_EQ(slurp(dir / "probe"), "160,96,10/1,5\n");
}
