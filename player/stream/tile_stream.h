#pragma once
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <unordered_map>
#include <vector>

#include "agreement/consensus_map.h"
#include "player/stream/upload_ring.h"
#include "scene/package_reader.h"

namespace vantage {

/// Units of upload.
enum class Resource : std::uint32_t {
    color,        ///< a tile of color
    masks,        ///< a tile of masks, followed by that of depth
    thumbnail,    ///< a photo's thumbnail
    coordinates,  ///< a piece of a photo's texture coordinates
    points,       ///< a block of points
};
inline constexpr std::size_t photo_resources = 4;  ///< all but points

/// A piece of the package to fetch; `key` is unique among those of its resource.
struct StreamRequest {
    Resource resource;
    std::uint32_t key;
    const package::DirectoryEntry* chunk;
    std::uint32_t block = 0;                          ///< in a chunk with blocks
    std::uint64_t first = 0, bytes = 0;               ///< in a chunk without blocks
    const package::DirectoryEntry* second = nullptr;  ///< chunk whose block of the same number follows
    bool reweighted = false;                          ///< of masks: with the consensus weights of `weights`
    const ConsensusMap* weights = nullptr;            ///< see set_weights

    /// Bytes in the ring: of tiles, decoded.
    std::uint64_t size() const;
    std::uint64_t identity() const { return std::uint64_t(resource) << 32 | key; }
};

/// A request whose bytes are in the ring; not `sound`: its checksum mismatched.
struct Fetched {
    StreamRequest request;
    UploadRing::Piece piece;
    bool sound;
};

/// Worker threads that copy or decode pieces of the mapped package into the upload ring. All functions are
/// for the OpenGL thread; only wait() waits.
class TileStream {
  public:
    TileStream(const PackageReader& package, std::size_t ring_bytes, unsigned threads);
    ~TileStream();
    TileStream(const TileStream&) = delete;
    TileStream& operator=(const TileStream&) = delete;

    /// Replaces the queue of requests, most urgent first. Requests in flight are not affected.
    void want(std::span<const StreamRequest> requests);
    /// The next fetched request; empty if there is none or it has more than `budget` bytes.
    std::optional<Fetched> take(std::size_t budget);
    /// Must be called when what was taken has been uploaded or discarded.
    void release(const Fetched& fetched);
    /// Ends a frame: see UploadRing::fence.
    void fence();
    /// Waits until something has been fetched, at most 2 ms. False if nothing is queued, in flight or
    /// fetched.
    bool wait();

    GLuint buffer() const { return ring_.buffer(); }
    std::size_t ring_bytes() const { return ring_.bytes(); }
    std::size_t waiting() const;
    /// Bytes read from the package since opening.
    std::uint64_t bytes_read() const;

  private:
    void work(std::stop_token stop);
    /// Adds to `read` the bytes of the package that it read.
    bool fetch(const StreamRequest& request, std::span<std::byte> to, std::uint64_t& read) const;

    const PackageReader& package_;
    UploadRing ring_;
    mutable std::mutex mutex_;
    std::condition_variable_any work_, fetched_;
    std::deque<StreamRequest> wanted_;
    std::deque<Fetched> done_;
    std::unordered_map<std::uint64_t, bool> begun_;  ///< in flight, or fetched and not taken
    std::uint64_t bytes_read_ = 0;
    std::vector<std::jthread> threads_;  ///< last: they use all members above
};

}  // namespace vantage
