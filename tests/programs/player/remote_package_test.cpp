// Tests both programs with the URL of a package instead of a file, from correct and faulty servers.
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "scene/package/package_reader.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"
#include "tests/scene/remote/fault_server.h"

using namespace vantage;

namespace {

class RemotePackages : public Overnight {
  protected:
    std::string content;

    void SetUp() override {
        Overnight::SetUp();
        for (const char* name : {"http_proxy", "https_proxy", "all_proxy", "ALL_PROXY", "HTTPS_PROXY"})
            ::unsetenv(name);
        copy_package(scene, {}, file);
        content = slurp(file);
    }
    FaultServer::Handler good() const {
        return [this](const Asked& asked) { return answer_well(asked, content); };
    }
    Outcome play(const std::string& package, const std::string& picture = "picture.png") const {
        return run("render " + package + " --photo 0002 --size 320x200 -o " + (dir / picture).string(), "",
                   VANTAGE_PLAYER);
    }
    std::string local_picture() const {
        const Outcome local = play(file.string(), "local.png");
        EXPECT_EQ(local.code, 0) << local.err;
        return slurp(dir / "local.png");
    }
    /// The path of the cached package, which is a sparse file.
    fs::path cached() const {
        for (const auto& entry : fs::recursive_directory_iterator(dir / "cache"))
            if (entry.path().extension() == ".vantage") return entry.path();
        return {};
    }
};

}  // namespace

TEST_F(RemotePackages, PictureIsThatOfTheFile) {
    const FaultServer server(good());
    const Outcome remote = play(server.url());
    EXPECT_EQ(remote.code, 0) << remote.err;
    EXPECT_TRUE(slurp(dir / "picture.png") == local_picture());
    EXPECT_NE(remote.err.find("MB fetched"), std::string::npos) << remote.err;
}

TEST_F(RemotePackages, SecondVisitIsFromTheCacheAndNeedsNoServer) {
    std::string url;
    {
        const FaultServer server(good());
        url = server.url();
        ASSERT_EQ(play(url).code, 0);
        const int before = server.requests();
        ASSERT_EQ(play(url, "again.png").code, 0);
        EXPECT_EQ(server.requests() - before, 1)
            << "there should be no requests besides the one that checks whether the file has changed";
    }
    const Outcome offline = play(url, "offline.png");
    EXPECT_EQ(offline.code, 0) << offline.err;
    EXPECT_NE(offline.err.find("the server cannot be reached"), std::string::npos) << offline.err;
    for (const char* name : {"picture.png", "again.png", "offline.png"})
        EXPECT_TRUE(slurp(dir / name) == local_picture()) << name;
}

TEST_F(RemotePackages, OpeningTakesThreeRoundTripsAndPicturesOnlyWhatTheyShow) {
    std::mutex mutex;
    std::vector<ByteRange> asked_for;
    const FaultServer server([&](const Asked& asked) {
        const std::scoped_lock lock(mutex);
        asked_for.push_back(clipped(asked, content));
        return answer_well(asked, content);
    });
    const Outcome list = run("list " + server.url(), "", VANTAGE_PLAYER);
    ASSERT_EQ(list.code, 0) << list.err;
    EXPECT_LE(asked_for.size(), 3u);
    asked_for.clear();
    ASSERT_EQ(play(server.url()).code, 0);
    std::uint64_t bytes = 0;
    for (const ByteRange& range : asked_for) bytes += range.size();
    EXPECT_LT(bytes, content.size());
}

TEST_F(RemotePackages, InfoAndCheckSayWhatTheySayOfTheFile) {
    const FaultServer server(good());
    const Outcome info = run("info --json " + server.url()), local = run("info --json " + file.string());
    EXPECT_EQ(info.code, 0) << info.err;
    EXPECT_EQ(info.out, local.out);
    const Outcome check = run("check --deep " + server.url());
    EXPECT_EQ(check.code, 0) << check.out << check.err;
    EXPECT_EQ(check.out, server.url() + ": valid, every tile read\n");
}

TEST_F(RemotePackages, DamageOnTheServerIsFoundByCheckAndNotShown) {
    const PackageReader package(file);
    const auto* tiles = package.find(package::Type::tiles, 2, 0);
    ASSERT_NE(tiles, nullptr);
    content[tiles->offset + tiles->length - 5] ^= 1;
    const FaultServer server(good());
    const Outcome check = run("check --deep " + server.url());
    EXPECT_EQ(check.code, int(Exit::damaged)) << check.out;
    EXPECT_NE(check.out.find("TILE of photo 2"), std::string::npos) << check.out;
}

TEST_F(RemotePackages, DamageOfTheCacheIsFetchedAgain) {
    const FaultServer server(good());
    ASSERT_EQ(play(server.url()).code, 0);
    const std::string local = local_picture();
    const PackageReader package(file);
    for (const package::DirectoryEntry& e : package.directory()) {
        if (e.length == 0) continue;
        std::fstream cache(cached(), std::ios::in | std::ios::out | std::ios::binary);
        cache.seekp(std::streamoff(e.offset + e.length / 2));
        cache.put(char(content[e.offset + e.length / 2] ^ 1));
    }
    const Outcome again = play(server.url(), "again.png");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(slurp(dir / "again.png") == local);
}

TEST_F(RemotePackages, FaultsOfTheServerAreOneLine) {
    const auto failed = [&](const FaultServer::Handler& handler, const std::string& part,
                            int code = int(Exit::input)) {
        fs::remove_all(dir / "cache");
        const FaultServer server(handler);
        for (const Outcome& outcome : {play(server.url()), run("info " + server.url())}) {
            EXPECT_EQ(outcome.code, code) << part << ": " << outcome.err;
            EXPECT_TRUE(one_line(outcome.err)) << outcome.err;
            EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
        }
    };
    failed(
        [](const Asked& asked) { return asked.send("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n"); },
        "404");
    failed(
        [&](const Asked& asked) {
            return asked.send("HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(content.size()) +
                              "\r\n\r\n" + content);
        },
        "range requests");
    const std::string page = content_of(300'000);
    failed([&](const Asked& asked) { return answer_well(asked, page); }, "not a Vantage package",
           int(Exit::damaged));
}

TEST_F(RemotePackages, ServerThatFailsWhileTilesAreFetchedIsOneLine) {
    const FaultServer server([&](const Asked& asked) {
        // The server sends the first half and fails for the rest.
        if (asked.range.begin < content.size() / 2) return answer_well(asked, content);
        return asked.send("HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\n\r\n");
    });
    const Outcome outcome = play(server.url() + " --quiet");
    EXPECT_EQ(outcome.code, int(Exit::input)) << outcome.err;
    EXPECT_TRUE(one_line(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find("503"), std::string::npos) << outcome.err;
}

TEST_F(RemotePackages, ObjectsOfASceneFileMayBeOnServers) {
    const FaultServer server(good());
    std::ofstream(dir / "two.toml")
        << "[[object]]\nname = \"a\"\npackage = \"scene.vantage\"\n\n[[object]]\nname = \"b\"\nmove = [20, "
           "0, 0]\npackage = \""
        << server.url() << "\"\n";
    const Outcome two = play((dir / "two.toml").string());
    EXPECT_EQ(two.code, 0) << two.err;
    EXPECT_GT(server.requests(), 0);
}
