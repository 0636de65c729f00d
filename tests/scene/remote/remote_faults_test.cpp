#include <atomic>
#include <set>

#include "tests/scene/remote/remote_test.h"

namespace vantage {

namespace {

using Handler = FaultServer::Handler;

class RemoteFaults : public RemoteTest {
  protected:
    const std::string content = content_of(40 * block + 123);

    /// The error from opening the file, without the URL at its beginning.
    std::string opening_error(const Handler& handler) {
        FaultServer server(handler);
        const std::string error = error_of([&] { RemoteFile(server.url(), options); });
        EXPECT_TRUE(error.starts_with(server.url() + ": ")) << error;
        return error.substr(std::min(error.size(), server.url().size() + 2));
    }
    /// The error from fetching bytes after the file was opened successfully.
    std::string fetching_error(const Handler& handler, ByteRange range = {5 * block, 7 * block}) {
        FaultServer server([&](const Asked& asked) {
            return asked.number == 0 ? answer_well(asked, content) : handler(asked);
        });
        RemoteFile file(server.url(), options);
        const std::string error = error_of([&] { EXPECT_TRUE(fetch(file, range)); });
        EXPECT_TRUE(error.starts_with(server.url() + ": ")) << error;
        EXPECT_FALSE(file.present(range));
        return error.substr(std::min(error.size(), server.url().size() + 2));
    }
    /// A handler that changes one part of a correct response.
    Handler changed(const std::function<void(Reply&, const Asked&)>& change) {
        return [this, change](const Asked& asked) {
            Reply reply(clipped(asked, content), content.size());
            change(reply, asked);
            return asked.send(reply.text() + body_of(asked, content));
        };
    }
};

}  // namespace

TEST_F(RemoteFaults, AnswerWithTheWholeFileIsNotDownloaded) {
    std::atomic<std::uint64_t> sent = 0;
    const std::string chunk(1 << 20, 'x');
    const std::string error = opening_error([&](const Asked& asked) {
        asked.send("HTTP/1.1 200 OK\r\nContent-Length: 100000000000\r\nETag: \"one\"\r\n\r\n");
        while (sent < std::uint64_t(1) << 30 && asked.send(chunk)) sent += chunk.size();
        return false;
    });
    EXPECT_EQ(
        error,
        "the server responds with 200 to a request for bytes 0 to 65535, expected 206; it must support range "
        "requests");
    EXPECT_LT(sent, 64u << 20);  // the connection's buffers
}

TEST_F(RemoteFaults, RefusalsAreReportedWithTheirCode) {
    for (const auto& [status, text] : {std::pair("404 Not Found", "the server responds with 404 (not found)"),
                                       std::pair("403 Forbidden", "the server responds with 403 (forbidden)"),
                                       std::pair("500 Oops", "the server responds with 500 to")}) {
        std::atomic<int> requests = 0;
        const std::string error = opening_error([&, status = status](const Asked& asked) {
            ++requests;
            return asked.send("HTTP/1.1 " + std::string(status) + "\r\nContent-Length: 4\r\n\r\noops");
        });
        EXPECT_TRUE(error.starts_with(text)) << error;
        EXPECT_EQ(requests, 1);
    }
}

TEST_F(RemoteFaults, BusyServerIsAskedAgain) {
    FaultServer server([&](const Asked& asked) {
        if (asked.number == 0) return asked.send("HTTP/1.1 503 Busy\r\nContent-Length: 0\r\n\r\n");
        return answer_well(asked, content);
    });
    RemoteFile file(server.url(), options);
    EXPECT_TRUE(same(file, {0, block}, content));
}

TEST_F(RemoteFaults, WrongRangeIsReported) {
    const auto range = [&](const std::string& value) {
        return changed(
            [value](Reply& r, const Asked&) { r.content_range = "Content-Range: " + value + "\r\n"; });
    };
    const std::string size = std::to_string(content.size());
    EXPECT_EQ(opening_error(range("bytes 1-65536/" + size)),
              "the server sends bytes 1 to 65536, expected bytes 0 to 65535");
    EXPECT_EQ(opening_error(range("bytes 0-65534/" + size)),
              "the server sends bytes 0 to 65534, expected bytes 0 to 65535");
    EXPECT_EQ(
        opening_error(range("bytes 0-65535/*")),
        "the response has an invalid Content-Range 'bytes 0-65535/*', expected bytes 0 to 65535 and the "
        "size of "
        "the file");
    EXPECT_EQ(
        opening_error(range("bytes 0-65535/65535")),
        "the response has an invalid Content-Range 'bytes 0-65535/65535', expected bytes 0 to 65535 and the "
        "size of the file");
    EXPECT_EQ(opening_error(changed([](Reply& r, const Asked&) { r.content_range = ""; })),
              "the response has no Content-Range, expected bytes 0 to 65535");
    EXPECT_EQ(opening_error(range("bytes 0-65535/9223372036854775807")),
              "the server states a size of 9223372036854775807 bytes, expected at most 1099511627776");
    EXPECT_EQ(fetching_error(range("bytes 0-131071/" + size)),
              "the server sends bytes 0 to 131071, expected bytes 327680 to 458751");
}

TEST_F(RemoteFaults, SizeThatChangesIsReported) {
    EXPECT_EQ(fetching_error(changed([](Reply& r, const Asked& asked) {
                  r.content_range = Reply(asked.range, 9999999).content_range;
              })),
              "the file has changed on the server: it has 9999999 bytes, expected " +
                  std::to_string(content.size()));
    EXPECT_EQ(
        fetching_error([](const Asked& asked) {
            return asked.send("HTTP/1.1 416 No\r\nContent-Range: bytes */70000\r\nContent-Length: 0\r\n\r\n");
        }),
        "the file has changed on the server: it has 70000 bytes, expected " + std::to_string(content.size()));
}

TEST_F(RemoteFaults, ValidatorThatChangesIsReported) {
    EXPECT_EQ(fetching_error(changed([](Reply& r, const Asked&) { r.etag = "ETag: \"two\"\r\n"; })),
              "the file has changed on the server: its ETag is '\"two\"', expected '\"one\"'");
    EXPECT_EQ(fetching_error(changed([](Reply& r, const Asked&) { r.etag = ""; })),
              "the file has changed on the server: its ETag is missing, expected '\"one\"'");
    const Handler dated = changed([](Reply& r, const Asked& asked) {
        r.etag = asked.number == 0 ? "Last-Modified: Monday\r\n" : "Last-Modified: Tuesday\r\n";
    });
    FaultServer server(dated);
    RemoteFile file(server.url(), options);
    EXPECT_EQ(error_of([&] {
                  EXPECT_TRUE(fetch(file, {5 * block, 6 * block}));
              }),
              server.url() +
                  ": the file has changed on the server: its Last-Modified is 'Tuesday', expected 'Monday'");
}

TEST_F(RemoteFaults, ServerWithoutValidatorsIsRefused) {
    const std::string expected =
        "the response has neither a strong ETag nor Last-Modified, so a change to the file could not be "
        "detected";
    EXPECT_EQ(opening_error(changed([](Reply& r, const Asked&) { r.etag = ""; })), expected);
    EXPECT_EQ(opening_error(changed([](Reply& r, const Asked&) { r.etag = "ETag: W/\"one\"\r\n"; })),
              expected);
}

TEST_F(RemoteFaults, EncodedBodyIsRefused) {
    EXPECT_EQ(opening_error(changed([](Reply& r, const Asked&) { r.other = "Content-Encoding: gzip\r\n"; })),
              "the response has the Content-Encoding 'gzip', expected identity");
}

TEST_F(RemoteFaults, EmptyFileIsRefused) {
    EXPECT_EQ(
        opening_error([](const Asked& asked) {
            return asked.send("HTTP/1.1 416 No\r\nContent-Range: bytes */0\r\nContent-Length: 0\r\n\r\n");
        }),
        "the file is empty");
    EXPECT_EQ(opening_error([](const Asked& asked) {
                  return asked.send("HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n");
              }),
              "the file is empty");
}

TEST_F(RemoteFaults, LongerBodyIsRefusedAndNothingBeyondItIsStored) {
    EXPECT_EQ(opening_error(
                  changed([](Reply& r, const Asked&) { r.content_length = "Content-Length: 65537\r\n"; })),
              "the server sends 65537 bytes, expected 65536 for bytes 0 to 65535");
    const Handler endless = [&](const Asked& asked) {
        Reply reply(asked.range, content.size());
        reply.content_length = "";  // the body then ends when the connection closes
        asked.send(reply.text());
        while (asked.send(std::string(64 << 10, 'x'))) {
        }
        return false;
    };
    EXPECT_EQ(opening_error(endless), "the server sends more than the 65536 bytes requested");
    FaultServer server(
        [&](const Asked& asked) { return asked.number == 0 ? answer_well(asked, content) : endless(asked); });
    RemoteFile file(server.url("/other"), options);
    EXPECT_NE(error_of([&] { EXPECT_TRUE(fetch(file, {2 * block, 3 * block})); }), "");
    EXPECT_EQ(text(file, {3 * block, 4 * block}), std::string(block, '\0'));
    EXPECT_FALSE(file.present({3 * block, 4 * block}));
}

TEST_F(RemoteFaults, ShorterBodyIsReportedAfterThreeTries) {
    std::atomic<int> tries = 0;
    const std::string error = fetching_error([&](const Asked& asked) {
        ++tries;
        Reply reply(asked.range, content.size());
        reply.content_length = "Transfer-Encoding: chunked\r\n";
        return asked.send(reply.text() + "3\r\n" + content.substr(asked.range.begin, 3) + "\r\n0\r\n\r\n");
    });
    EXPECT_EQ(error, "the body of the response is too short; 9 of 131072 bytes had arrived");
    EXPECT_EQ(tries, 3);
}

TEST_F(RemoteFaults, StallIsReported) {
    options.stall_timeout = std::chrono::seconds(1);
    const std::string error = fetching_error([&](const Asked& asked) {
        asked.send(Reply(asked.range, content.size()).text());
        asked.wait_for_client();
        return false;
    });
    EXPECT_EQ(error,
              "the server stalls: fewer than 256 bytes per second for 1 s; 0 of 131072 bytes had arrived");
}

TEST_F(RemoteFaults, CutConnectionIsContinuedWhereItWasCut) {
    std::vector<ByteRange> asked_for;
    FaultServer server([&](const Asked& asked) {
        if (asked.number == 0) return answer_well(asked, content);
        asked_for.push_back(asked.range);
        // There are more disconnections than retries, but each attempt delivers one block.
        const std::string body = body_of(asked, content).substr(0, block + 1000);
        asked.send(Reply(asked.range, content.size()).text() + body);
        return body.size() == asked.range.size();
    });
    RemoteFile file(server.url(), options);
    ASSERT_TRUE(fetch(file, {5 * block, 10 * block}));
    EXPECT_TRUE(same(file, {5 * block, 10 * block}, content));
    ASSERT_EQ(asked_for.size(), 5);
    EXPECT_EQ(asked_for[1], (ByteRange{6 * block + 1000, 10 * block}));
    EXPECT_EQ(file.traffic().bytes_received, 6 * block);
}

TEST_F(RemoteFaults, FirstAnswerThatIsCutIsContinued) {
    FaultServer server([&](const Asked& asked) {
        const std::string body = body_of(asked, content);
        asked.send(Reply(clipped(asked, content), content.size()).text() +
                   body.substr(0, asked.number == 0 ? 1000 : body.size()));
        return false;
    });
    RemoteFile file(server.url(), options);
    EXPECT_TRUE(same(file, {0, block}, content));
    EXPECT_EQ(server.requests(), 2);
}

TEST_F(RemoteFaults, ConnectionThatIsAlwaysCutIsReportedAfterThreeTries) {
    std::atomic<int> tries = 0;
    EXPECT_EQ(fetching_error([&](const Asked& asked) {
                  ++tries;
                  asked.send(Reply(asked.range, content.size()).text());
                  return false;
              }),
              "the connection was cut; 0 of 131072 bytes had arrived");
    EXPECT_EQ(tries, 3);
}

TEST_F(RemoteFaults, RefusedConnectionAndUnknownHostAreReported) {
    const std::string url = "http://127.0.0.1:" + std::to_string(free_port()) + "/scan.vantage";
    const std::string refused = error_of([&] { RemoteFile(url, options); });
    EXPECT_TRUE(refused.starts_with(url + ": cannot connect: ")) << refused;
    const std::string unknown = error_of([&] { RemoteFile("http://no-such-host.invalid/a", options); });
    EXPECT_TRUE(unknown.starts_with("http://no-such-host.invalid/a: cannot find the host: ")) << unknown;
}

TEST_F(RemoteFaults, EndlessHeadersAreRefused) {
    EXPECT_EQ(opening_error([](const Asked& asked) {
                  asked.send("HTTP/1.1 206 Partial Content\r\n");
                  while (asked.send("X-Padding: " + std::string(1000, 'x') + "\r\n")) {
                  }
                  return false;
              }),
              "the headers of the response exceed 65536 bytes");
}

TEST_F(RemoteFaults, RedirectsAreFollowedButNotForever) {
    const auto redirect = [](const Asked& asked, const std::string& to) {
        return asked.send("HTTP/1.1 302 Found\r\nContent-Length: 3\r\nLocation: " + to + "\r\n\r\nold");
    };
    FaultServer server([&](const Asked& asked) {
        return asked.has("GET /scan") ? redirect(asked, "/moved") : answer_well(asked, content);
    });
    RemoteFile file(server.url(), options);
    EXPECT_TRUE(fetch(file, {2 * block, 3 * block}));
    EXPECT_TRUE(same(file, {2 * block, 3 * block}, content));

    EXPECT_EQ(opening_error([&](const Asked& asked) { return redirect(asked, "/scan.vantage"); }),
              "the server redirects more than 5 times");
    const std::string elsewhere =
        opening_error([&](const Asked& asked) { return redirect(asked, "file:///etc/passwd"); });
    EXPECT_TRUE(elsewhere.starts_with("the server redirects to a URL that is neither http nor https"))
        << elsewhere;
}

TEST_F(RemoteFaults, FailureOfOneRangeLeavesTheFileUsable) {
    std::atomic<bool> broken = true;
    FaultServer server([&](const Asked& asked) {
        if (broken && asked.range.begin == 5 * block)
            return asked.send("HTTP/1.1 500 Oops\r\nContent-Length: 0\r\n\r\n");
        return answer_well(asked, content);
    });
    RemoteFile file(server.url(), options);
    const std::vector<ByteRange> both = {{5 * block, 6 * block}, {8 * block, 9 * block}};
    EXPECT_NE(error_of([&] { EXPECT_TRUE(file.fetch(both)); }), "");
    EXPECT_TRUE(fetch(file, both[1]));
    broken = false;
    EXPECT_TRUE(file.fetch(both));
    EXPECT_TRUE(same(file, both[0], content));
}

}  // namespace vantage
