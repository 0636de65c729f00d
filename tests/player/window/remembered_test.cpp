#include "player/window/remembered.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/text/error.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

Remembered with_recent(std::size_t length) {
    Remembered r;
    r.recent.assign(8, std::string(length, 'a'));  // of several lengths, so that mixed texts are noticed
    return r;
}

/// Starts another process, which exits with 0 if all its writes succeed.
pid_t start_player(const std::filesystem::path& folder, std::size_t length) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    try {
        for (int n = 0; n < 40; ++n) write_settings(folder, with_recent(length));
    } catch (const Error&) {
        ::_exit(1);
    }
    ::_exit(0);
}

struct RememberedSettings : TemporaryFolder {};

TEST_F(RememberedSettings, AreWholeWhileTwoPlayersWriteThem) {
    write_settings(dir, with_recent(1));
    for (const pid_t player : {start_player(dir, 20), start_player(dir, 20000)}) {
        int status = 0, invalid = 0;
        while (::waitpid(player, &status, WNOHANG) == 0)
            invalid += !nlohmann::json::parse(slurp(dir / "player.json"), nullptr, false).is_object();
        EXPECT_EQ(status, 0);
        EXPECT_EQ(invalid, 0);
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(dir), {}), 1) << "no temporary files remain";
}

TEST_F(RememberedSettings, KeepTheRestWhenAFileIsOpened) {
    Remembered r = with_recent(3);
    r.window.width = 1234;
    write_settings(dir, r);
    for (const char* file : {"/scans/one.vantage", "/scans/two.vantage", "/scans/one.vantage"})
        remember_opened(dir, file);
    r = read_settings(dir, {});
    EXPECT_EQ(r.window.width, 1234);
    ASSERT_EQ(r.recent.size(), 8u);
    EXPECT_EQ(r.recent[0], "/scans/one.vantage");
    EXPECT_EQ(r.recent[1], "/scans/two.vantage");
    EXPECT_EQ(r.recent[2], "aaa");
}

TEST_F(RememberedSettings, ThatCannotBeWrittenAreAnError) {
    std::ofstream(dir / "file");
    EXPECT_THROW(write_settings(dir / "file", {}), Error);
}

}  // namespace
}  // namespace vantage
