#pragma once
#include <cstddef>
#include <span>

#include "base/gl/object.h"

namespace vantage {

/// A buffer that is rewritten in each frame and grows as needed. Use it only on the OpenGL thread.
class GrowingBuffer {
  public:
    explicit GrowingBuffer(const char* label) : label_(label) {}

    /// Discards the content and allocates `bytes`. The buffer's name may change.
    void begin(std::size_t bytes);
    /// Appends. Throws std::logic_error if the allocated size is exceeded.
    void write(std::span<const std::byte> bytes);
    GLuint id() const { return buffer_.id(); }

  private:
    const char* label_;
    gl::Buffer buffer_;
    std::size_t room_ = 0, used_ = 0;
};

}  // namespace vantage
