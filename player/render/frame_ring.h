#pragma once
#include <cstddef>
#include <vector>

#include "gl/object.h"

namespace vantage {

/// A persistently mapped buffer for what the processor writes anew for every pass: photos, page tables, draw
/// commands. Its regions are used in turn, each guarded by a fence.
class FrameRing {
  public:
    explicit FrameRing(std::size_t region_bytes);
    ~FrameRing();
    FrameRing(const FrameRing&) = delete;
    FrameRing& operator=(const FrameRing&) = delete;

    /// The next region; waits only where the card is a whole ring behind.
    void begin();
    /// Room in the region: where to write, and its offset in the buffer, aligned for a storage buffer. Throws
    /// std::logic_error where the region is too small.
    struct Room {
        std::byte* memory;
        GLintptr offset;
        GLsizeiptr bytes;
    };
    Room take(std::size_t bytes);
    /// Puts the region's fence behind the commands that read it.
    void end();
    GLuint buffer() const { return buffer_.id(); }

  private:
    std::size_t region_bytes_, used_ = 0, region_ = 0;
    std::vector<GLsync> fences_;
    gl::Buffer buffer_;
    std::byte* mapped_ = nullptr;
};

}  // namespace vantage
