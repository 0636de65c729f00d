#pragma once
#include <cstddef>
#include <vector>

#include "base/gl/object.h"

namespace vantage {

/// A persistently mapped buffer for the data that the CPU writes for every pass: photos, page tables, draw
/// commands. Its regions are used in turn, each guarded by a fence.
class FrameRing {
  public:
    FrameRing(const char* label, std::size_t region_bytes);
    ~FrameRing();
    FrameRing(const FrameRing&) = delete;
    FrameRing& operator=(const FrameRing&) = delete;

    /// Moves to the next region; waits only if the graphics card is a whole ring behind.
    void begin();
    /// Space in the region: a pointer for writing, and its offset in the buffer, aligned for a uniform or
    /// storage buffer. Throws std::logic_error if the region is too small.
    struct Space {
        std::byte* memory;
        GLintptr offset;
        GLsizeiptr bytes;
    };
    Space take(std::size_t bytes);
    /// Sets the region's fence, after the commands that read it.
    void end();
    GLuint buffer() const { return buffer_.id(); }

  private:
    std::size_t region_bytes_, used_ = 0, region_ = 0;
    std::vector<GLsync> fences_;
    gl::Buffer buffer_;
    std::byte* mapped_ = nullptr;
};

}  // namespace vantage
