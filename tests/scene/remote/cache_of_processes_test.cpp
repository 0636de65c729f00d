// A cache that several processes use simultaneously.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>
#include <thread>

#include "tests/scene/remote/nginx.h"
#include "tests/scene/remote/remote_test.h"

namespace vantage {

namespace {

/// A cache that is shared by several processes. When the test starts the processes, it has no threads.
class RemoteCacheOfProcessesAtLength : public RemoteTest {
  protected:
    const std::string content = content_of(100 * block + 50);

    void SetUp() override {
        RemoteTest::SetUp();
        if (!Nginx::installed()) GTEST_SKIP() << "nginx is not installed (package nginx-light)";
        write(dir / "served" / "scan.vantage", content);
    }

    /// Reads random ranges and retains each of them while reading. Returns the number of ranges with wrong
    /// bytes.
    int read_at_random(const std::string& url, unsigned seed) {
        RemoteFile file(url, options);
        std::mt19937 random(seed);
        int wrong = 0;
        for (int i = 0; i < 60; ++i) {
            const std::uint64_t begin = random() % 97 * block;
            const ByteRange range{begin, begin + 3 * block};
            const auto kept = file.keep({&range, 1});
            wrong += !fetch(file, range) || !same(file, range, content);
        }
        return wrong;
    }
};

/// Starts a process that runs a function and exits with the function's result.
pid_t start(const std::function<int()>& f) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    int status = 99;
    try {
        status = f();
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
    }
    ::_exit(status);
}

int exit_status(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_F(RemoteCacheOfProcessesAtLength, BlocksThatAnotherProcessKeepsStay) {
    const Nginx nginx(dir / "nginx", dir / "served");
    options.cache_bytes = 20 * block;
    const ByteRange range{10 * block, 14 * block};
    int ready[2], leave[2];
    ASSERT_EQ(::pipe(ready) + ::pipe(leave), 0);
    const pid_t child = start([&] {
        RemoteFile other(nginx.url(), options);
        const auto kept = other.keep({&range, 1});
        char byte = fetch(other, range);
        if (::write(ready[1], &byte, 1) != 1 || ::read(leave[0], &byte, 1) != 1) return 1;
        return same(other, range, content) ? 0 : 2;
    });
    ::close(ready[1]);
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    RemoteFile file(nginx.url(), options);
    const auto fetch_others = [&] {
        for (std::uint64_t i = 20; i < 100; ++i) ASSERT_TRUE(fetch(file, {i * block, (i + 1) * block}));
    };
    fetch_others();
    EXPECT_TRUE(file.present(range));
    ASSERT_EQ(::write(leave[1], &byte, 1), 1);
    EXPECT_EQ(exit_status(child), 0);
    fetch_others();
    EXPECT_FALSE(file.present(range));
}

TEST_F(RemoteCacheOfProcessesAtLength, ThreeMayReadAndEvictAtOnce) {
    const Nginx nginx(dir / "nginx", dir / "served");
    options.cache_bytes = 30 * block;
    std::vector<pid_t> children;
    for (unsigned seed = 0; seed < 3; ++seed)
        children.push_back(start([&] { return read_at_random(nginx.url(), seed); }));
    for (const pid_t child : children) EXPECT_EQ(exit_status(child), 0);
}

TEST_F(RemoteCacheOfProcessesAtLength, OneThatIsKilledLeavesNoWrongBytes) {
    const Nginx nginx(dir / "nginx", dir / "served", "limit_rate 4m;");
    std::uint64_t present = 0;
    for (int round = 0; round < 5; ++round) {
        const pid_t child = start([&] {
            RemoteFile file(nginx.url(), options);
            return fetch(file, {0, content.size()}) ? 0 : 1;
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(100 + 70 * round));
        ::kill(child, SIGKILL);
        exit_status(child);
        RemoteFile file(nginx.url(), options);
        for (std::uint64_t at = 0; at + block <= content.size(); at += block)
            if (file.present({at, at + block})) {
                ++present;
                ASSERT_TRUE(same(file, {at, at + block}, content));
            }
        file.discard({30 * block, content.size()});  // so that the next one has something to do
    }
    EXPECT_GT(present, 5);  // more than the first block
    RemoteFile file(nginx.url(), options);
    ASSERT_TRUE(fetch(file, {0, content.size()}));
    EXPECT_TRUE(same(file, {0, content.size()}, content));
}

}  // namespace vantage
