#include "scene/remote/remote_file.h"

#include <atomic>
#include <random>
#include <thread>

#include "tests/scene/remote/nginx.h"
#include "tests/scene/remote/remote_test.h"

namespace vantage {

namespace {

class RemoteFileFetches : public RemoteTest {
  protected:
    const std::string content = content_of(200 * block + 777);
};

/// Tests that fetch from nginx, which serves `content` as /scan.vantage.
class RemoteFileAtLength : public RemoteFileFetches {
  protected:
    void SetUp() override {
        RemoteFileFetches::SetUp();
        if (!Nginx::installed()) GTEST_SKIP() << "nginx is not installed (package nginx-light)";
        write(dir / "served" / "scan.vantage", content);
    }

    /// The number of requests in nginx's log.
    std::size_t logged() const {
        const std::string log = slurp(dir / "nginx" / "access.log");
        return std::size_t(std::ranges::count(log, '\n'));
    }
};

/// Reads random ranges and returns the number of ranges with wrong bytes.
int read_at_random(RemoteFile& file, const std::string& content, unsigned seed, int times) {
    std::mt19937_64 random(seed);
    int wrong = 0;
    for (int i = 0; i < times; ++i) {
        std::vector<ByteRange> ranges;
        for (int k = 0; k < 3; ++k) {
            const std::uint64_t begin = random() % content.size();
            ranges.push_back({begin, std::min<std::uint64_t>(content.size(), begin + random() % 300'000)});
        }
        wrong += !file.fetch(ranges);
        for (const ByteRange& range : ranges) {
            wrong += !file.present(range);
            wrong += std::memcmp(file.bytes().data() + range.begin, content.data() + range.begin,
                                 range.size()) != 0;
        }
    }
    return wrong;
}

/// Calls f(0) to f(7), each on its own thread.
void in_eight_threads(const std::function<void(unsigned)>& f) {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < 8; ++i) threads.emplace_back(f, i);
}

}  // namespace

TEST_F(RemoteFileAtLength, HasTheSizeAndTheBytesOfTheOriginal) {
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url(), options);
    EXPECT_EQ(file.size(), content.size());
    EXPECT_EQ(file.url(), nginx.url());
    EXPECT_FALSE(file.offline());
    EXPECT_TRUE(file.present({0, block}));
    EXPECT_FALSE(file.present({0, block + 1}));
    EXPECT_EQ(file.traffic().requests, 1);
    EXPECT_EQ(file.traffic().bytes_received, block);
    ASSERT_TRUE(fetch(file, {0, content.size()}));
    EXPECT_GT(file.traffic().bytes_per_second, 0);  // over the last two seconds
    EXPECT_TRUE(same(file, {0, content.size()}, content));
    EXPECT_EQ(slurp(file.path()), content);
    EXPECT_EQ(file.traffic().bytes_received, content.size());
}

TEST_F(RemoteFileAtLength, EightThreadsReadTheRightBytesAndFetchEachOnce) {
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url(), options);
    std::atomic<int> wrong = 0;
    in_eight_threads([&](unsigned seed) { wrong += read_at_random(file, content, seed, 40); });
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(file.traffic().bytes_received, content.size());
}

TEST_F(RemoteFileAtLength, ThreadsThatWantTheSameRangeShareItsRequest) {
    const Nginx nginx(dir / "nginx", dir / "served", "limit_rate 1m;");
    RemoteFile file(nginx.url(), options);
    std::atomic<int> fetched = 0;
    in_eight_threads([&](unsigned) { fetched += fetch(file, {50 * block, 60 * block}); });
    EXPECT_EQ(fetched, 8);
    EXPECT_EQ(file.traffic().requests, 2);
}

TEST_F(RemoteFileAtLength, NeighboringRangesAreFetchedTogether) {
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url(), options);
    std::vector<ByteRange> tiles;
    for (std::uint64_t i = 0; i < 100; ++i)
        tiles.push_back({2 * block + i * 20'000, 2 * block + i * 20'000 + 4'000});
    std::ranges::shuffle(tiles, std::mt19937(1));
    ASSERT_TRUE(file.fetch(tiles));
    EXPECT_EQ(file.traffic().requests, 2);
    for (const ByteRange& tile : tiles) EXPECT_TRUE(same(file, tile, content));
    ASSERT_TRUE(file.fetch(tiles));
    EXPECT_EQ(file.traffic().requests, 2);
    EXPECT_EQ(logged(), 2);
}

TEST_F(RemoteFileAtLength, LargeRangeIsSplit) {
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url(), options);
    ASSERT_TRUE(fetch(file, {block, content.size()}));
    EXPECT_EQ(file.traffic().requests, 1 + 4);  // 200 blocks in parts of 64
}

TEST_F(RemoteFileAtLength, FileSmallerThanTheFirstRequestIsWhole) {
    write(dir / "served" / "small.vantage", content.substr(0, 1000));
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url("/small.vantage"), options);
    EXPECT_EQ(file.size(), 1000);
    EXPECT_TRUE(file.present({0, 1000}));
    EXPECT_TRUE(same(file, {0, 1000}, content));
}

TEST_F(RemoteFileAtLength, LargestPackagesAreOpenedAtOnce) {
    const std::uint64_t size = std::uint64_t(100) << 30;
    std::ofstream large(dir / "served" / "large.vantage", std::ios::binary);
    if (!large.seekp(std::streamoff(size - 5)).write("end!\n", 5).flush())
        GTEST_SKIP() << "the file system does not support files of 100 GiB";
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url("/large.vantage"), options);
    EXPECT_EQ(file.size(), size);
    ASSERT_TRUE(fetch(file, {size - 5, size}));
    EXPECT_EQ(text(file, {size - 5, size}), "end!\n");
    EXPECT_TRUE(fetch(file, {size / 2, size / 2 + 10}));
    EXPECT_EQ(file.traffic().bytes_received, 3 * block);
    EXPECT_LT(cache_on_disk(), 8 << 20);  // mostly the table of blocks
}

TEST_F(RemoteFileAtLength, RangeBeyondTheFileIsABug) {
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url(), options);
    const auto asks = [&](ByteRange range) {
        return error_of([&] { EXPECT_TRUE(fetch(file, range)); }, Exit::internal);
    };
    EXPECT_NE(asks({0, content.size() + 1}), "");
    EXPECT_NE(asks({5, 4}), "");
    EXPECT_EQ(asks({content.size(), content.size()}), "");
}

TEST_F(RemoteFileAtLength, DiscardedBytesAreFetchedAgain) {
    const Nginx nginx(dir / "nginx", dir / "served");
    RemoteFile file(nginx.url(), options);
    const ByteRange range{10 * block, 11 * block};
    ASSERT_TRUE(fetch(file, range));
    std::fstream(file.path(), std::ios::in | std::ios::out | std::ios::binary).seekp(10 * block) << "damage";
    EXPECT_FALSE(same(file, range, content));
    file.discard({10 * block + 7, 10 * block + 8});
    EXPECT_FALSE(file.present(range));
    ASSERT_TRUE(fetch(file, range));
    EXPECT_TRUE(same(file, range, content));
}

TEST_F(RemoteFileAtLength, StopReturnsAndCancelsTheRequest) {
    const Nginx nginx(dir / "nginx", dir / "served", "limit_rate 128k;");
    RemoteFile file(nginx.url(), options);
    std::stop_source stop;
    const ByteRange all{0, content.size()};  // would take many seconds
    std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        stop.request_stop();
    });
    EXPECT_FALSE(file.fetch({&all, 1}, stop.get_token()));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const std::uint64_t received = file.traffic().bytes_received;
    std::this_thread::sleep_for(std::chrono::seconds(1));
    EXPECT_EQ(file.traffic().bytes_received, received);  // nothing more arrives
    EXPECT_LT(file.traffic().requests, 8);
    EXPECT_TRUE(fetch(file, {199 * block, content.size()}));
    EXPECT_TRUE(same(file, {199 * block, content.size()}, content));
}

TEST_F(RemoteFileAtLength, RequestGoesOnIfAnotherThreadWaitsForIt) {
    const Nginx nginx(dir / "nginx", dir / "served", "limit_rate 512k;");
    RemoteFile file(nginx.url(), options);
    const ByteRange range{8 * block, 16 * block};
    std::stop_source stop;
    std::atomic<bool> fetched = false;
    {
        std::jthread patient([&] { fetched = fetch(file, range); });
        std::jthread hasty([&] { EXPECT_FALSE(file.fetch({&range, 1}, stop.get_token())); });
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        stop.request_stop();
    }
    EXPECT_TRUE(fetched);
    EXPECT_EQ(file.traffic().requests, 2);
    EXPECT_TRUE(same(file, range, content));
}

TEST_F(RemoteFileFetches, OpeningCanBeStopped) {
    std::stop_source stop;
    FaultServer server([&](const Asked& asked) {
        stop.request_stop();
        asked.wait_for_client();
        return false;
    });
    options.stall_timeout = std::chrono::seconds(100);
    EXPECT_EQ(error_of([&] { RemoteFile(server.url(), options, stop.get_token()); }, Exit::interrupted),
              server.url() + ": stopped while being opened");
}

TEST_F(RemoteFileFetches, ConnectionsAreKept) {
    std::set<int> connections;
    std::mutex mutex;
    FaultServer server([&](const Asked& asked) {
        const std::scoped_lock lock(mutex);
        connections.insert(asked.fd);
        return answer_well(asked, content);
    });
    RemoteFile file(server.url(), options);
    for (std::uint64_t i = 1; i < 20; ++i) ASSERT_TRUE(fetch(file, {2 * i * block, (2 * i + 1) * block}));
    EXPECT_EQ(connections.size(), 1);
}

TEST_F(RemoteFileFetches, NoMoreRequestsThanAllowedAreInFlight) {
    std::atomic<int> in_flight = 0, most = 0;
    FaultServer server([&](const Asked& asked) {
        most = std::max<int>(most, ++in_flight);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        --in_flight;
        return answer_well(asked, content);
    });
    options.max_requests = 3;
    RemoteFile file(server.url(), options);
    std::vector<ByteRange> ranges;
    for (std::uint64_t i = 1; i < 20; ++i) ranges.push_back({2 * i * block, (2 * i + 1) * block});
    ASSERT_TRUE(file.fetch(ranges));
    EXPECT_EQ(most, 3);
}

TEST_F(RemoteFileFetches, SmallFetchDoesNotWaitForALargeOne) {
    FaultServer server([&](const Asked& asked) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return answer_well(asked, content);
    });
    options.max_requests = 1;
    RemoteFile file(server.url(), options);
    std::vector<ByteRange> many;
    for (std::uint64_t i = 1; i < 90; ++i) many.push_back({2 * i * block, (2 * i + 1) * block});
    std::jthread large([&] { EXPECT_TRUE(file.fetch(many)); });
    while (file.traffic().requests < 5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_TRUE(fetch(file, {199 * block, 200 * block}));
    EXPECT_FALSE(file.present(many.back()));
}

class RemoteFileOverTlsAtLength : public RemoteFileAtLength {
  protected:
    void SetUp() override {
        RemoteFileAtLength::SetUp();
        if (IsSkipped()) return;
        const std::string command =
            "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj "
            "/CN=127.0.0.1 -addext "
            "subjectAltName=IP:127.0.0.1 -keyout " +
            key().string() + " -out " + certificate().string() + " 2>/dev/null";
        if (std::system(command.c_str()) != 0) GTEST_SKIP() << "openssl is not installed";
    }
    std::filesystem::path key() const { return dir / "key.pem"; }
    std::filesystem::path certificate() const { return dir / "certificate.pem"; }
    std::string tls_settings() const {
        return "ssl_certificate " + certificate().string() + "; ssl_certificate_key " + key().string() + ";";
    }
};

TEST_F(RemoteFileOverTlsAtLength, ReadsTheRightBytesOverOneConnection) {
    const Nginx nginx(dir / "nginx", dir / "served", "", tls_settings(), true);
    options.certificates = certificate();
    RemoteFile file(nginx.url(), options);
    std::atomic<int> wrong = 0;
    in_eight_threads([&](unsigned seed) { wrong += read_at_random(file, content, seed, 10); });
    EXPECT_EQ(wrong, 0);
    EXPECT_NE(slurp(dir / "nginx" / "access.log").find("HTTP/2.0\" 206"), std::string::npos);
}

TEST_F(RemoteFileOverTlsAtLength, RefusesACertificateOfAnUnknownAuthority) {
    const Nginx nginx(dir / "nginx", dir / "served", "", tls_settings(), true);
    const std::string error = error_of([&] { RemoteFile(nginx.url(), options); });
    EXPECT_TRUE(error.starts_with(nginx.url() + ": the server's certificate is not valid: ")) << error;
}

TEST_F(RemoteFileOverTlsAtLength, RefusesARedirectToHttp) {
    const Nginx plain(dir / "plain", dir / "served");
    const Nginx nginx(dir / "nginx", dir / "served", "return 302 " + plain.url() + ";", tls_settings(), true);
    options.certificates = certificate();
    EXPECT_EQ(error_of([&] { RemoteFile(nginx.url(), options); }),
              nginx.url() + ": the server redirects from https to http; such redirects are not followed");
}

}  // namespace vantage
