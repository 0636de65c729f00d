#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "scene/remote/byte_range.h"

namespace vantage {

/// Bytes that depend on their position, so that a shifted or missing range is noticed.
inline std::string content_of(std::uint64_t size, std::uint64_t seed = 1) {
    std::string bytes(size, '\0');
    std::uint64_t x = seed * 0x9e3779b97f4a7c15u;
    for (char& byte : bytes) {
        x = x * 6364136223846793005u + 1442695040888963407u;
        byte = char(x >> 56);
    }
    return bytes;
}

/// A free port below the range from which the system assigns ports. Each process gets a different one.
inline int free_port() {
    static int next = int(::getpid()) * 16;
    for (;;) {
        const int port = 16'000 + next++ % 16'000;
        const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(std::uint16_t(port));
        const bool free = ::bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
        ::close(fd);
        if (free) return port;
    }
}

/// A client's request, and the connection for the response.
struct Asked {
    int fd = -1;
    int number = 0;       ///< index of the request
    std::string headers;  ///< including the request line
    ByteRange range;      ///< empty if the request has none
    /// Returns false if the client has closed the connection.
    bool send(const std::string& bytes) const {
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t n = ::send(fd, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
            if (n <= 0) return false;
            at += std::size_t(n);
        }
        return true;
    }
    /// Blocks until the client closes the connection.
    void wait_for_client() const {
        char byte = 0;
        while (::recv(fd, &byte, 1, 0) > 0) {
        }
    }
    bool has(const std::string& text) const { return headers.find(text) != std::string::npos; }
};

/// A server on 127.0.0.1 whose responses are written byte by byte by the test.
class FaultServer {
  public:
    /// Responds to one request and returns whether to keep the connection.
    using Handler = std::function<bool(const Asked&)>;

    explicit FaultServer(Handler handler) : handler_(std::move(handler)) {
        listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t length = sizeof address;
        ::bind(listener_, reinterpret_cast<sockaddr*>(&address), length);
        ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
        ::listen(listener_, 64);
        port_ = ntohs(address.sin_port);
        acceptor_ = std::thread([this] { accept_all(); });
    }

    ~FaultServer() {
        ::shutdown(listener_, SHUT_RDWR);
        acceptor_.join();
        ::close(listener_);
        {
            const std::scoped_lock lock(mutex_);
            for (const int fd : open_) ::shutdown(fd, SHUT_RDWR);
        }
        for (std::thread& thread : connections_) thread.join();
        for (const int fd : open_) ::close(fd);
    }

    std::string url(const std::string& path = "/scan.vantage") const {
        return "http://127.0.0.1:" + std::to_string(port_) + path;
    }
    int requests() const { return requests_; }

  private:
    void accept_all() {
        for (;;) {
            const int fd = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
            if (fd < 0) return;
            const std::scoped_lock lock(mutex_);
            open_.push_back(fd);
            connections_.emplace_back([this, fd] { serve(fd); });
        }
    }

    void serve(int fd) {
        std::string received;
        for (;;) {
            char buffer[4096];
            const auto end = received.find("\r\n\r\n");
            if (end == std::string::npos) {
                const ssize_t n = ::recv(fd, buffer, sizeof buffer, 0);
                if (n <= 0) break;
                received.append(buffer, std::size_t(n));
                continue;
            }
            Asked asked{fd, requests_++, received.substr(0, end + 2), {}};
            received.erase(0, end + 4);
            const std::string name = "Range: bytes=";
            if (const auto at = asked.headers.find("\r\n" + name); at != std::string::npos) {
                char* rest = nullptr;
                asked.range.begin = std::strtoull(asked.headers.c_str() + at + 2 + name.size(), &rest, 10);
                asked.range.end = std::strtoull(rest + 1, nullptr, 10) + 1;
            }
            if (!handler_(asked)) break;
        }
        ::shutdown(fd, SHUT_RDWR);  // closed when the server ends, so that its number is not reused
    }

    Handler handler_;
    int listener_ = -1;
    int port_ = 0;
    std::atomic<int> requests_ = 0;
    std::mutex mutex_;
    std::vector<int> open_;
    std::list<std::thread> connections_;
    std::thread acceptor_;
};

/// The headers of a correct response. Each part can be replaced with a wrong one.
struct Reply {
    std::string status = "206 Partial Content";
    std::string content_range{}, content_length{};
    std::string etag = "ETag: \"one\"\r\n";
    std::string other{};

    Reply(ByteRange range, std::uint64_t total)
        : content_range("Content-Range: bytes " + std::to_string(range.begin) + "-" +
                        std::to_string(range.end - 1) + "/" + std::to_string(total) + "\r\n"),
          content_length("Content-Length: " + std::to_string(range.size()) + "\r\n") {}
    std::string text() const {
        return "HTTP/1.1 " + status + "\r\n" + content_range + content_length + etag + other + "\r\n";
    }
};

/// The requested part of the content.
inline ByteRange clipped(const Asked& asked, const std::string& content) {
    return {asked.range.begin, std::min<std::uint64_t>(asked.range.end, content.size())};
}
inline std::string body_of(const Asked& asked, const std::string& content) {
    const ByteRange range = clipped(asked, content);
    return content.substr(range.begin, range.size());
}
/// Sends the correct response.
inline bool answer_well(const Asked& asked, const std::string& content) {
    return asked.send(Reply(clipped(asked, content), content.size()).text() + body_of(asked, content));
}

}  // namespace vantage
