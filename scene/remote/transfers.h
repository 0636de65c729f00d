#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "scene/remote/request.h"

namespace vantage {

/// Settings for connections to a server.
struct TransferOptions {
    std::chrono::milliseconds connect_timeout{10'000};
    std::chrono::seconds stall_timeout{20};
    std::chrono::milliseconds retry_pause{
        250};                            ///< before the second try; four times as long before the third
    int max_in_flight = 6;               ///< requests
    std::filesystem::path certificates;  ///< PEM file of trusted authorities; empty: the system's file
};

/// Carries out requests for one URL in a separate thread, in the order of their turns. Requests share
/// connections: with HTTP/2, there is one connection, otherwise one for each request in flight. Bodies are
/// passed on as they arrive, with a buffer of 64 KiB per request. After a transient failure, a request is
/// retried from the bytes that have already arrived, until three successive tries make no progress.
/// Certificates are always verified. Redirects are followed, but never from https to http. Thread-safe.
class Transfers {
  public:
    /// Throws Error(memory) if the thread cannot be started, and Error(internal) if libcurl cannot be
    /// initialized.
    Transfers(std::string url, const TransferOptions& options);
    /// Drops unfinished requests.
    ~Transfers();

    /// `tries`: maximum number of successive tries without progress.
    void start(std::shared_ptr<Request> request, int tries = 3);
    void cancel(Request& request);

    std::uint64_t bytes_received() const;  ///< bytes of response bodies
    std::uint64_t requests() const;        ///< each try counts
    double bytes_per_second() const;       ///< rate of reception over the last two seconds

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vantage
