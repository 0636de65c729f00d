#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "gl/object.h"

namespace vantage {

/// A persistently mapped buffer from which the graphics card copies: worker threads fill pieces of it, the
/// OpenGL thread uploads them and puts a fence behind. Pieces are given and taken back in order. Nothing here
/// waits. Not thread-safe by itself.
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
    /// Empty where the ring has not the room now.
    std::optional<Piece> take(std::size_t bytes);
    std::span<std::byte> memory(const Piece& piece) { return {mapped_ + piece.offset, piece.bytes}; }
    /// The piece was uploaded by commands that the next fence() follows, or is not wanted any more.
    void release(const Piece& piece);
    /// Puts a fence behind what was released since the last, and takes back what the card has finished with.
    void fence();

    GLuint buffer() const { return buffer_.id(); }
    std::size_t bytes() const { return bytes_; }

  private:
    struct Given {
        std::size_t offset, bytes;
        std::uint64_t fence = 0;  ///< number of the fence behind its use; 0: still in use
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
