#include <signal.h>
#include <sys/resource.h>

#include <atomic>
#include <random>
#include <thread>

#include "tests/scene/remote/remote_test.h"

namespace vantage {

namespace {

namespace fs = std::filesystem;

/// A server that can be switched off and whose file can be replaced.
class RemoteCache : public RemoteTest {
  protected:
    std::string content = content_of(100 * block + 50);
    std::string etag = "\"one\"";
    std::string status;  ///< status of an error response; empty: responses are correct
    std::atomic<bool> reachable = true;

    FaultServer server{[this](const Asked& asked) {
        if (!reachable) return false;
        if (!status.empty()) return asked.send("HTTP/1.1 " + status + "\r\nContent-Length: 0\r\n\r\n");
        if (asked.has("If-None-Match: " + etag + "\r\n"))
            return asked.send("HTTP/1.1 304 Not Modified\r\nETag: " + etag + "\r\n\r\n");
        Reply reply(clipped(asked, content), content.size());
        reply.etag = "ETag: " + etag + "\r\n";
        return asked.send(reply.text() + body_of(asked, content));
    }};

    RemoteFile open(const std::string& path = "/scan.vantage") {
        return RemoteFile(server.url(path), options);
    }
    void replace_on_server() {
        content = content_of(content.size(), 2);
        etag = "\"two\"";
    }
    /// The folder of the file in the cache.
    fs::path folder_of_scan() { return open().path().parent_path(); }
    void fetch_all() {
        RemoteFile file = open();
        ASSERT_TRUE(fetch(file, {0, content.size()}));
    }
};

}  // namespace

TEST_F(RemoteCache, SecondOpeningFetchesNothingAgain) {
    fetch_all();
    RemoteFile file = open();
    EXPECT_FALSE(file.offline());
    EXPECT_TRUE(fetch(file, {0, content.size()}));
    EXPECT_EQ(file.traffic().requests, 1);  // to check that the file is current
    EXPECT_EQ(file.traffic().bytes_received, 0);
    EXPECT_EQ(file.traffic().bytes_from_cache, content.size());
    EXPECT_TRUE(same(file, {0, content.size()}, content));
}

TEST_F(RemoteCache, WithoutTheFirstBytesIsCompletedWhenOpened) {
    { RemoteFile file = open(); }
    options.first_bytes = 4 * block;
    {
        RemoteFile file = open();
        EXPECT_TRUE(file.present({0, 4 * block}));
        EXPECT_TRUE(same(file, {0, 4 * block}, content));
    }
    options.first_bytes = 8 * block;
    reachable = false;
    EXPECT_NE(error_of([&] { open(); }), "");
}

TEST_F(RemoteCache, ServesTheFileIfTheServerCannotBeReached) {
    fetch_all();
    const int before = server.requests();
    options.connect_timeout = std::chrono::seconds(1);
    reachable = false;
    RemoteFile file = open();
    EXPECT_TRUE(file.offline());
    EXPECT_EQ(server.requests(), before + 1);
    EXPECT_TRUE(fetch(file, {0, content.size()}));
    EXPECT_EQ(server.requests(), before + 1);
    EXPECT_TRUE(same(file, {0, content.size()}, content));
}

TEST_F(RemoteCache, BytesThatItLacksAreAnErrorUntilTheServerIsBack) {
    { RemoteFile file = open(); }
    reachable = false;
    RemoteFile file = open();
    EXPECT_NE(error_of([&] { EXPECT_TRUE(fetch(file, {5 * block, 6 * block})); }), "");
    EXPECT_TRUE(file.offline());
    reachable = true;
    EXPECT_TRUE(fetch(file, {5 * block, 6 * block}));
    EXPECT_FALSE(file.offline());
    EXPECT_TRUE(same(file, {5 * block, 6 * block}, content));
}

TEST_F(RemoteCache, ServesTheFileIfTheServerIsBusyButNotIfItHasNoSuchFile) {
    fetch_all();
    status = "503 Service Unavailable";
    EXPECT_TRUE(open().offline());
    status = "404 Not Found";
    EXPECT_NE(error_of([&] { open(); }), "");
}

TEST_F(RemoteCache, IsStartedAnewIfTheFileHasChanged) {
    fetch_all();
    replace_on_server();
    RemoteFile file = open();
    EXPECT_TRUE(same(file, {0, block}, content));
    EXPECT_FALSE(file.present({block, 2 * block}));
    ASSERT_TRUE(fetch(file, {0, content.size()}));
    EXPECT_TRUE(same(file, {0, content.size()}, content));
}

TEST_F(RemoteCache, FileThatChangesWhileOpenIsAnErrorAndWhatWasFetchedStays) {
    RemoteFile old = open();
    ASSERT_TRUE(fetch(old, {0, 10 * block}));
    const std::string old_content = content;
    replace_on_server();
    EXPECT_EQ(
        error_of([&] {
            EXPECT_TRUE(fetch(old, {20 * block, 21 * block}));
        }),
        server.url() + ": the file has changed on the server: its ETag is '\"two\"', expected '\"one\"'");
    RemoteFile current = open();
    ASSERT_TRUE(fetch(current, {0, 10 * block}));
    EXPECT_TRUE(same(current, {0, 10 * block}, content));
    EXPECT_TRUE(same(old, {0, 10 * block}, old_content));
    EXPECT_EQ(old.size(), old_content.size());
}

TEST_F(RemoteCache, DamagedFilesOfItAreReplaced) {
    fetch_all();
    const fs::path folder = folder_of_scan();
    const std::string origin = slurp(folder / "origin"), blocks = slurp(folder / "blocks");
    const std::vector<std::pair<std::string, std::string>> damages = {
        {"origin", origin.substr(0, origin.size() / 2)},
        {"origin", "vantage-remote 2\nsomething later\n"},
        {"origin", origin + std::string(1 << 20, 'x')},
        {"blocks", ""},
        {"blocks", blocks.substr(0, 40)},
        {"blocks", blocks + "1234"},
        {"blocks", std::string(blocks.size(), '\xff')},
        {"package.vantage", "short"}};
    for (const auto& [name, damage] : damages) {
        write(folder / name, damage);
        RemoteFile file = open();
        EXPECT_EQ(file.path().parent_path(), folder);
        EXPECT_FALSE(file.present({block, 2 * block})) << name << " " << damage.size();
        ASSERT_TRUE(fetch(file, {0, content.size()}));
        EXPECT_TRUE(same(file, {0, content.size()}, content)) << name;
    }
    for (const char* name : {"blocks", "package.vantage"}) {
        fs::remove(folder / name);
        RemoteFile file = open();
        ASSERT_TRUE(fetch(file, {0, content.size()}));
        EXPECT_TRUE(same(file, {0, content.size()}, content)) << name;
    }
}

TEST_F(RemoteCache, TableOfAnotherVersionIsNotBelieved) {
    fetch_all();
    const fs::path folder = folder_of_scan();
    const std::string blocks = slurp(folder / "blocks");
    replace_on_server();
    { RemoteFile file = open(); }
    write(folder / "blocks", blocks);
    RemoteFile file = open();
    ASSERT_TRUE(fetch(file, {0, content.size()}));
    EXPECT_TRUE(same(file, {0, content.size()}, content));
}

TEST_F(RemoteCache, FilesOfOthersAreLeftAlone) {
    const fs::path folder = folder_of_scan();
    fs::remove_all(folder);
    write(folder / "origin.part-7", "vant");  // left by a crash
    EXPECT_EQ(folder_of_scan(), folder);
    fs::remove_all(folder);
    const std::string other = std::string(32, 'a'), third = std::string(32, 'b');
    write(folder / "origin", "[remote]");
    write(folder / "package.vantage", "my only copy");
    write(options.cache / other / "package.vantage", "my only copy");
    write(options.cache / "thesis" / "origin", "vantage-remote 1\n");
    write(dir / "elsewhere" / "origin", "vantage-remote 1\n");
    write(dir / "elsewhere" / "package.vantage", "my only copy");
    fs::create_directory_symlink(dir / "elsewhere", options.cache / third);
    options.cache_bytes = 0;
    {
        RemoteFile file = open();
        EXPECT_NE(file.path().parent_path(), folder);
        ASSERT_TRUE(fetch(file, {0, content.size()}));
        EXPECT_TRUE(same(file, {0, block}, content));
        write(file.path().parent_path() / "notes.txt", "mine");
        replace_on_server();
        EXPECT_TRUE(fs::exists(open().path().parent_path() / "notes.txt"));
    }
    { RemoteFile file = open("/other.vantage"); }
    EXPECT_EQ(slurp(folder / "origin"), "[remote]");
    EXPECT_EQ(slurp(folder / "package.vantage"), "my only copy");
    EXPECT_EQ(slurp(options.cache / other / "package.vantage"), "my only copy");
    EXPECT_EQ(slurp(options.cache / third / "package.vantage"), "my only copy");
    EXPECT_TRUE(fs::exists(options.cache / "thesis" / "origin"));
    int notes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(options.cache))
        notes += entry.path().filename() == "notes.txt";
    EXPECT_EQ(notes, 1);
}

TEST_F(RemoteCache, LinkInPlaceOfTheDataIsNotWrittenThrough) {
    const fs::path folder = folder_of_scan();
    const std::string precious(content.size(), 'p');
    write(dir / "precious", precious);
    fs::remove(folder / "package.vantage");
    fs::create_symlink(dir / "precious", folder / "package.vantage");
    fetch_all();
    EXPECT_EQ(slurp(dir / "precious"), precious);
}

TEST_F(RemoteCache, LeastRecentlyUsedFilesAreDeleted) {
    const std::uint64_t each = content.size();
    options.cache_bytes = 3 * each + each / 2;
    for (const char* path : {"/a", "/b", "/c", "/d"}) {
        RemoteFile file = open(path);
        ASSERT_TRUE(fetch(file, {0, content.size()}));
        if (*path == '/' && path[1] == 'c') RemoteFile again = open("/a");  // used: b is the oldest
        EXPECT_LE(cache_on_disk(), options.cache_bytes);
    }
    const auto cached = [&](const char* path) { return open(path).present({0, content.size()}); };
    EXPECT_TRUE(cached("/a"));
    EXPECT_TRUE(cached("/c"));
    EXPECT_TRUE(cached("/d"));
    EXPECT_FALSE(cached("/b"));
}

TEST_F(RemoteCache, OpenFilesAreNotDeleted) {
    options.cache_bytes = content.size() + content.size() / 2;
    RemoteFile first = open("/a");
    ASSERT_TRUE(fetch(first, {0, content.size()}));
    RemoteFile second = open("/b");
    ASSERT_TRUE(fetch(second, {0, content.size()}));
    EXPECT_TRUE(fs::exists(first.path()));
    EXPECT_TRUE(first.present({0, content.size()}));
    EXPECT_TRUE(same(first, {0, content.size()}, content));
}

TEST_F(RemoteCache, LeastRecentlyFetchedBlocksOfTheOpenFileAreFreed) {
    options.cache_bytes = 40 * block;
    RemoteFile file = open();
    for (std::uint64_t i = 1; i < 100; ++i) {
        ASSERT_TRUE(fetch(file, {i * block, (i + 1) * block}));
        ASSERT_TRUE(fetch(file, {block, 2 * block}));  // in constant use
        ASSERT_TRUE(same(file, {i * block, (i + 1) * block}, content));
        ASSERT_LE(cache_on_disk(), options.cache_bytes);
    }
    EXPECT_TRUE(file.present({0, 2 * block}));
    EXPECT_TRUE(file.present({95 * block, 100 * block}));
    EXPECT_FALSE(file.present({2 * block, 3 * block}));
    EXPECT_EQ(text(file, {2 * block, 3 * block}), std::string(block, '\0'));
    EXPECT_EQ(file.traffic().requests, 100);  // none of them twice
    ASSERT_TRUE(fetch(file, {2 * block, 3 * block}));
    EXPECT_TRUE(same(file, {2 * block, 3 * block}, content));
}

TEST_F(RemoteCache, KeptBlocksStayUntilTheyAreReleased) {
    options.cache_bytes = 20 * block;
    RemoteFile file = open();
    const ByteRange range{10 * block + 5, 14 * block};
    auto kept = file.keep({&range, 1});
    const auto again = file.keep({&range, 1});
    ASSERT_TRUE(fetch(file, range));
    const auto fetch_others = [&] {
        for (std::uint64_t i = 20; i < 100; ++i) ASSERT_TRUE(fetch(file, {i * block, (i + 1) * block}));
    };
    fetch_others();
    EXPECT_TRUE(file.present(range));
    kept.reset();
    fetch_others();
    EXPECT_TRUE(file.present(range));
    EXPECT_TRUE(same(file, range, content));
    const_cast<std::shared_ptr<const void>&>(again).reset();
    fetch_others();
    EXPECT_FALSE(file.present(range));
}

TEST_F(RemoteCache, RangeLargerThanTheLimitIsFetchedAndFreedLater) {
    options.cache_bytes = 10 * block;
    RemoteFile file = open();
    ASSERT_TRUE(fetch(file, {block, 51 * block}));
    EXPECT_TRUE(same(file, {0, 51 * block}, content));
    // The thread that receives a range may hold the range slightly longer than the fetch lasts.
    std::uint64_t next = 60;
    do ASSERT_TRUE(fetch(file, {next * block, (next + 1) * block}));
    while (cache_on_disk() > options.cache_bytes && ++next < 80);
    EXPECT_LE(cache_on_disk(), options.cache_bytes);
    EXPECT_TRUE(same(file, {next * block, (next + 1) * block}, content));
}

TEST_F(RemoteCache, ThreadsThatEvictEachOthersBlocksReadTheRightBytes) {
    options.cache_bytes = 30 * block;
    RemoteFile file = open();
    std::atomic<int> wrong = 0;
    {
        std::vector<std::jthread> threads;
        for (unsigned seed = 0; seed < 8; ++seed)
            threads.emplace_back([&, seed] {
                std::mt19937 random(seed);
                for (int i = 0; i < 60; ++i) {
                    const std::uint64_t begin = random() % 97 * block;
                    const ByteRange range{begin, begin + 3 * block};
                    const auto kept = file.keep({&range, 1});
                    wrong += !fetch(file, range) || !file.present(range) || !same(file, range, content);
                }
            });
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(cache_on_disk(), options.cache_bytes + 8 * 3 * block);
}

TEST_F(RemoteCache, FolderThatCannotBeWrittenIsReported) {
    write(dir / "file", "");
    options.cache = dir / "file" / "cache";
    const std::string error = error_of([&] { open(); }, Exit::storage);
    EXPECT_TRUE(error.starts_with(options.cache.string() + ": cannot create: ")) << error;
}

TEST_F(RemoteCache, WriteThatFailsIsReported) {
    RemoteFile file = open();
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlim_t was = std::exchange(limit.rlim_cur, 50 * block);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string error = error_of([&] { EXPECT_TRUE(fetch(file, {0, content.size()})); }, Exit::storage);
    limit.rlim_cur = was;
    ::setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_EQ(error, file.path().string() + ": cannot write: File too large");
    EXPECT_FALSE(file.present({50 * block, 51 * block}));
    EXPECT_TRUE(fetch(file, {0, content.size()}));
    EXPECT_TRUE(same(file, {0, content.size()}, content));
}

}  // namespace vantage
