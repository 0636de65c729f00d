#pragma once
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include "player/stream/remote_bytes.h"
#include "player/stream/stream_request.h"
#include "player/stream/streamed_so_far.h"
#include "player/stream/upload_ring.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A request whose bytes are in the ring or could not be fetched.
struct Fetched {
    enum class State {
        valid,
        damaged,  ///< its checksum mismatched
        absent    ///< the server could not be reached (see TileStream::failure)
    };
    StreamRequest request;
    std::optional<UploadRing::Piece> piece;  ///< none if absent
    State state;

    std::size_t bytes() const { return piece ? piece->bytes : 0; }
};

/// Worker threads that copy or decode pieces of the mapped package into the upload ring. Pieces of a remote
/// package are downloaded beforehand. All functions must be called on the OpenGL thread; only wait() blocks.
class TileStream {
  public:
    TileStream(const PackageReader& package, std::size_t ring_bytes, unsigned threads);
    ~TileStream();
    TileStream(const TileStream&) = delete;
    TileStream& operator=(const TileStream&) = delete;

    /// Replaces the queue of requests; the most urgent one comes first. Requests in flight are not affected.
    void want(std::span<const StreamRequest> requests);
    /// The next fetched request; empty if there is none, or if that request has more than `budget` bytes.
    std::optional<Fetched> take(std::size_t budget);
    /// Must be called when the taken piece has been uploaded or discarded.
    void release(const Fetched& fetched);
    /// Ends a frame (see UploadRing::fence).
    void fence();
    /// Waits until something has been fetched, but at most 2 ms. False if nothing is queued, in flight or
    /// fetched.
    bool wait();

    GLuint buffer() const { return ring_.buffer(); }
    std::size_t ring_bytes() const { return ring_.bytes(); }
    std::size_t waiting() const;
    StreamedSoFar streamed() const;
    /// The reason for the last failed fetch; empty if none has failed.
    std::string failure() const;

  private:
    struct Task {
        StreamRequest request;
        std::optional<UploadRing::Piece> piece;
        Held held;
        std::string failure;
    };
    /// Removes and returns the next request that can be started. The mutex must be locked.
    std::optional<Task> next_task();
    std::optional<Task> next_arrival();
    /// Must be called with the mutex unlocked.
    Fetched carry_out(Task& task, std::uint64_t& read, std::stop_token stop);
    void work(std::stop_token stop);
    /// Adds the number of bytes read from the package to `read`.
    bool fetch(const StreamRequest& request, std::span<std::byte> to, std::uint64_t& read,
               std::stop_token stop) const;
    bool point_block_valid(const StreamRequest& request) const;
    bool fetch_tiles(const StreamRequest& request, std::span<std::byte> to, std::uint64_t& read,
                     std::stop_token stop) const;

    const PackageReader& package_;
    UploadRing ring_;
    mutable std::mutex mutex_;
    std::condition_variable_any work_, fetched_;
    std::vector<StreamRequest> wanted_;  ///< in reverse order: the next one is last
    std::deque<Fetched> done_;
    std::unordered_map<std::uint64_t, bool> begun_;  ///< in flight, or fetched but not yet taken
    StreamedSoFar streamed_;
    std::string failure_;
    std::unique_ptr<RemoteBytes> remote_;  ///< null unless the package is remote; uses the mutex
    std::vector<std::jthread> threads_;    ///< declared last, because the threads use all members above
};

}  // namespace vantage
