// Tests the program vantage-player: its pictures, and its one-line message and exit code if the package is
// damaged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "player/render/picture.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/run_program.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

struct Rendered {
    int code;
    std::string message, picture;
};

class PlayerProgram : public TemporaryFolder {
  protected:
    fs::path file = dir / "scene.vantage";
    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(spec_named("tiny"), dir / "scene");
        copy_package(dir / "scene", {}, file);
    }

    Rendered play(const std::string& options) const {
        const fs::path picture = dir / "picture.png", message = dir / "message";
        fs::remove(picture);
        const std::string command = std::string(VANTAGE_PLAYER " render ") + file.string() + " -q -o " +
                                    picture.string() + " " + options + " 2>" + message.string();
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(message), slurp(picture)};
    }
    std::vector<package::DirectoryEntry> chunks() const {
        const PackageReader reader(file);
        return {reader.directory().begin(), reader.directory().end()};
    }
    void flip(std::uint64_t at) const {
        std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
        f.seekg(std::streamoff(at));
        const char was = char(f.get());
        f.seekp(std::streamoff(at));
        f.put(char(was ^ 0x10));
    }
    void expect_damage_said(const std::vector<package::DirectoryEntry>& damaged) const {
        const Rendered good = play("--photo 0002");
        ASSERT_EQ(good.code, 0) << good.message;
        for (const package::DirectoryEntry& e : damaged) {
            if (e.length == 0) continue;
            const std::string type(reinterpret_cast<const char*>(&e.type), 4);
            flip(e.offset + e.length / 2);
            const Rendered found = play("--photo 0002");
            flip(e.offset + e.length / 2);
            if (found.code == 0)
                EXPECT_TRUE(found.picture == good.picture && found.message.empty()) << type << " " << e.photo;
            else
                EXPECT_TRUE(found.code == int(Exit::damaged) && one_line(found.message))
                    << type << " " << e.photo << ": " << found.code << " " << found.message;
            const bool read = e.photo == package::scene_wide && type != "STAT" && type != "REGI" &&
                              type != "PAIR";  // not read by the player
            EXPECT_TRUE(!read || found.code != 0) << type;
        }
        EXPECT_EQ(play("--photo 0002").picture, good.picture);
    }
    /// Truncates the package before every `step`-th chunk.
    void expect_truncation_said(std::size_t step) const {
        const auto all = chunks();
        for (std::size_t i = all.size(); i > 0; i -= std::min(i, step)) {
            fs::resize_file(file, all[i - 1].offset);
            const Rendered found = play("--photo 0002");
            EXPECT_EQ(found.code, int(Exit::damaged));
            EXPECT_TRUE(one_line(found.message)) << found.message;
            EXPECT_TRUE(found.picture.empty());
        }
    }
};
class PlayerProgramAtLength : public PlayerProgram {};

}  // namespace

TEST_F(PlayerProgram, DamageIsReportedInOneLineOrDoesNotMatter) {
    std::vector<package::DirectoryEntry> of_one_photo = chunks();
    std::erase_if(of_one_photo, [](auto& e) { return e.photo != package::scene_wide && e.photo != 2; });
    expect_damage_said(of_one_photo);
}

TEST_F(PlayerProgramAtLength, DamageIsReportedInOneLineOrDoesNotMatter) { expect_damage_said(chunks()); }

TEST_F(PlayerProgram, TruncatedPackageIsReportedInOneLine) { expect_truncation_said(10); }

TEST_F(PlayerProgramAtLength, TruncatedPackageIsReportedInOneLine) { expect_truncation_said(1); }

TEST_F(PlayerProgram, TheFirstPictureOfTheWindowShowsPhotos) {
    if (std::system("command -v xvfb-run >/dev/null") != 0) GTEST_SKIP() << "xvfb-run is not installed";
    const auto after = [&](int frames) {
        const fs::path picture = dir / "window.png";
        const std::string command = "xvfb-run -a " VANTAGE_PLAYER " " + file.string() +
                                    " -q --no-saved-settings --photo 0002 --size 900x700 --frames " +
                                    std::to_string(frames) + " --screenshot " + picture.string();
        EXPECT_EQ(std::system(command.c_str()), 0);
        return read_png(picture);
    };
    const Picture first = after(1), later = after(40);
    double squares = 0;
    int values = 0;
    for (int y = 100; y < 500; ++y)
        for (int x = 320; x < 540; ++x)  // between the panels, which the first picture lacks
            for (int c = 0; c < 3; ++c, ++values) {
                const auto at = std::size_t(4 * (y * first.width + x) + c);
                squares += std::pow(double(first.rgba[at]) - double(later.rgba[at]), 2);
            }
    EXPECT_GT(10 * std::log10(255.0 * 255 * values / squares), 20);
}

TEST_F(PlayerProgram, RejectsInvalidRequests) {
    EXPECT_EQ(play("--photo nobody").code, int(Exit::usage));
    EXPECT_EQ(play("--photo 0002 --size 0x10").code, int(Exit::usage));
    EXPECT_EQ(play("--path " + (dir / "none").string()).code, int(Exit::input));
    EXPECT_EQ(play("").code, int(Exit::usage));
    fs::remove(file);
    const Rendered gone = play("--photo 0002");
    EXPECT_EQ(gone.code, int(Exit::input));
    EXPECT_TRUE(one_line(gone.message)) << gone.message;
}

TEST_F(PlayerProgram, APictureNamedLikeAnotherFormatIsRefusedInsteadOfMadeAFolder) {
    const auto refused = [&](const std::string& name, const std::string& options) {
        const Outcome o =
            run_command(VANTAGE_PLAYER " " + with_file(options, file) + " -o " + (dir / name).string(), dir);
        EXPECT_EQ(o.code, int(Exit::usage)) << name;
        EXPECT_TRUE(one_line(o.err)) << o.err;
        EXPECT_FALSE(fs::exists(dir / name)) << name;
        return o.err;
    };
    for (const char* name : {"x.jpg", "X.JPEG", "x.tif", "x.mp4"})
        EXPECT_THAT(refused(name, "render --photo 0002"), testing::HasSubstr("ends with .png")) << name;
    EXPECT_THAT(refused("x.png", "render --photo 0001 0002"), testing::HasSubstr("a folder, for 2"));
    EXPECT_THAT(refused("x.gif", "video --turntable"), testing::HasSubstr("FILE.webm or a folder"));
    fs::create_directory(dir / "scan.jpg");
    const Outcome into = run_command(
        VANTAGE_PLAYER " render " + file.string() + " -q --photo 0002 -o " + (dir / "scan.jpg").string(),
        dir);
    EXPECT_EQ(into.code, 0) << into.err;
    EXPECT_TRUE(fs::exists(dir / "scan.jpg" / "0002.png"))
        << "a folder that exists should stay a folder, even with a file extension";
}

TEST_F(PlayerProgram, CoordinatesPerVertexAreRefusedWhereThereAreNone) {
    PrepareSettings settings;
    settings.effects[Effect::per_fragment] = EffectChoice::on;
    prepare(read_scene(discover(dir / "scene")), settings, file, [](const Progress&) {});
    const Rendered none = play("--photo 0002 --coordinates vertex");
    EXPECT_EQ(none.code, int(Exit::usage));
    EXPECT_TRUE(one_line(none.message)) << none.message;
    EXPECT_NE(none.message.find("--vertex-coordinates"), std::string::npos) << none.message;
    settings.vertex_coordinates = true;
    prepare(read_scene(discover(dir / "scene")), settings, file, [](const Progress&) {});
    EXPECT_EQ(play("--photo 0002 --coordinates vertex").code, 0);
}
