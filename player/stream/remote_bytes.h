#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "player/stream/stream_request.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The requested bytes of a remote package. Separate threads fetch the bytes, the most urgent first, and
/// combine neighboring ranges into one transfer. Fetched bytes stay readable until they are taken or no
/// longer requested. Thread-safe.
class RemoteBytes {
  public:
    /// `arrived` is called on the fetching threads when bytes have arrived or could not be fetched.
    RemoteBytes(const PackageReader& package, std::function<void()> arrived);
    ~RemoteBytes();

    /// Replaces the queue; the most urgent request comes first. Cancels transfers that no request in the new
    /// queue needs.
    void want(std::span<const StreamRequest> requests);
    /// Result of a request.
    struct Arrival {
        StreamRequest request;
        Held held;            ///< null if the bytes could not be fetched
        std::string failure;  ///< why the bytes could not be fetched
    };
    /// Removes and returns the most urgent request whose bytes have arrived, unless `accepts` rejects it.
    /// `accepts` is called only for requests whose bytes were fetched.
    std::optional<Arrival> take(const std::function<bool(const StreamRequest&)>& accepts);

  private:
    /// Requests that are fetched together.
    struct Group {
        std::vector<StreamRequest> requests;
        std::stop_source stop;
    };
    void work(std::stop_token stop);
    /// The most urgent requests that are not in flight and have not arrived. The mutex must be locked.
    std::vector<StreamRequest> next_requests() const;
    /// Fetches with the mutex unlocked.
    void fetch(Group& group, std::unique_lock<std::mutex>& lock);
    Held hold(const Group& group) const;

    const PackageReader& package_;
    std::function<void()> arrived_;
    mutable std::mutex mutex_;
    std::condition_variable_any work_;
    std::vector<StreamRequest> wanted_;                    ///< not taken
    std::unordered_map<std::uint64_t, Arrival> arrivals_;  ///< arrivals not yet taken, by identity
    std::unordered_set<std::uint64_t> fetching_;
    std::vector<Group*> groups_;         ///< in flight
    std::vector<std::jthread> threads_;  ///< declared last, because the threads use all members above
};

}  // namespace vantage
