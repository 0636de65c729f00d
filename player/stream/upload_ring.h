#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "base/gl/object.h"

namespace vantage {

/// A persistently mapped buffer for uploads: worker threads fill pieces of it, and the OpenGL thread uploads
/// the pieces and sets a fence. Pieces are handed out and reclaimed in order. No function waits. Not
/// thread-safe.
class UploadRing {
  public:
    explicit UploadRing(std::size_t bytes);
    ~UploadRing();
    UploadRing(const UploadRing&) = delete;
    UploadRing& operator=(const UploadRing&) = delete;

    struct Piece {
        std::size_t offset, bytes;
        std::uint64_t number;
    };
    /// Returns nullopt if the ring does not currently have enough space.
    std::optional<Piece> take(std::size_t bytes);
    std::span<std::byte> memory(const Piece& piece) { return {mapped_ + piece.offset, piece.bytes}; }
    /// Must be called when the piece has been uploaded (before the next fence()) or is no longer needed.
    void release(const Piece& piece);
    /// Sets a fence for the pieces released since the last fence, and reclaims pieces whose fence has been
    /// signaled.
    void fence();

    GLuint buffer() const { return buffer_.id(); }
    std::size_t bytes() const { return bytes_; }

  private:
    struct Given {
        std::size_t offset, bytes;
        std::uint64_t fence = 0;  ///< number of the fence after its last use; 0: still in use
    };
    struct Fence {
        std::uint64_t number;
        GLsync sync;
    };

    std::size_t bytes_, head_ = 0;
    gl::Buffer buffer_;
    std::byte* mapped_ = nullptr;
    std::deque<Given> given_;  ///< oldest first
    std::uint64_t first_ = 0;  ///< number of the oldest piece
    std::deque<Fence> fences_;
    std::uint64_t next_fence_ = 1, passed_ = 0;
    bool released_ = false;
};

}  // namespace vantage
