#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/gl/object.h"

namespace vantage::gl {

/// A mapped buffer of 32-bit words that commands fill and the processor reads when they have finished,
/// without waiting for the graphics card unless asked to. Belongs to the OpenGL thread.
class Readback {
  public:
    Readback() = default;
    ~Readback() { release(); }
    Readback(const Readback&) = delete;
    Readback& operator=(const Readback&) = delete;

    /// Allocates the buffer. False if it cannot be mapped.
    bool allocate(const char* label, std::size_t words);
    void release();
    /// Whether there is a buffer.
    explicit operator bool() const { return !words_.empty(); }
    GLuint id() const { return buffer_.id(); }

    /// Marks the end of the commands that fill the buffer.
    void begin();
    /// Whether those commands have not been found finished yet: the buffer must not be filled again.
    bool pending() const { return fence_ != nullptr; }
    /// The words, once, when the commands have finished; `wait` waits for up to ten seconds.
    std::optional<std::span<const std::uint32_t>> take(bool wait);

  private:
    Buffer buffer_;
    std::span<const std::uint32_t> words_;
    GLsync fence_ = nullptr;
};

}  // namespace vantage::gl
