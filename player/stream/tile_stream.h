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

#include "player/stream/upload_ring.h"
#include "scene/package_reader.h"

namespace vantage {

/// What goes to the graphics card as one.
enum class Resource : std::uint32_t {
    color,        ///< a colour tile
    masks,        ///< a tile of masks and the same of depth behind it
    thumbnail,    ///< a photo's thumbnail
    coordinates,  ///< a piece of a photo's texture coordinates
};
inline constexpr std::size_t resources = 4;

/// A piece of the package to fetch; `key` tells it from others of its resource.
struct StreamRequest {
    Resource resource;
    std::uint32_t key;
    const package::DirectoryEntry* chunk;
    std::uint32_t block = 0;                          ///< of a chunk with blocks
    std::uint64_t first = 0, bytes = 0;               ///< of a chunk without
    const package::DirectoryEntry* second = nullptr;  ///< block of the same number behind the first

    std::uint64_t size() const;
    std::uint64_t identity() const { return std::uint64_t(resource) << 32 | key; }
};

/// A request whose bytes lie in the ring, or whose checksum was wrong.
struct Fetched {
    StreamRequest request;
    UploadRing::Piece piece;
    bool sound;
};

/// Worker threads that bring pieces of the mapped package into the upload ring. All functions are for the
/// OpenGL thread; none waits but wait().
class TileStream {
  public:
    TileStream(const PackageReader& package, std::size_t ring_bytes, unsigned threads);
    ~TileStream();
    TileStream(const TileStream&) = delete;
    TileStream& operator=(const TileStream&) = delete;

    /// From now on these are wanted, most urgent first; what was asked before, is not among them and was not
    /// begun is dropped.
    void want(std::span<const StreamRequest> requests);
    /// The next that is fetched and has at most `budget` bytes.
    std::optional<Fetched> take(std::size_t budget);
    /// What was taken has been uploaded, or thrown away.
    void release(const Fetched& fetched);
    /// Ends a frame: see UploadRing::fence.
    void fence();
    /// For a moment, until something is fetched. False where nothing is wanted, under way or fetched.
    bool wait();

    GLuint buffer() const { return ring_.buffer(); }
    std::size_t ring_bytes() const { return ring_.bytes(); }
    std::size_t waiting() const;
    /// Bytes read from the package since opening.
    std::uint64_t bytes_read() const;

  private:
    void work(std::stop_token stop);
    bool fetch(const StreamRequest& request, std::span<std::byte> to) const;

    const PackageReader& package_;
    UploadRing ring_;
    mutable std::mutex mutex_;
    std::condition_variable_any work_, fetched_;
    std::deque<StreamRequest> wanted_;
    std::deque<Fetched> done_;
    std::unordered_map<std::uint64_t, bool> begun_;  ///< being fetched, or fetched and not taken
    std::uint64_t bytes_read_ = 0;
    std::vector<std::jthread> threads_;  ///< last: they use all of the above
};

}  // namespace vantage
