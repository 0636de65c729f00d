#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/gl/object.h"

namespace vantage::gl {

/// A mapped buffer of 32-bit words that GPU commands fill. The CPU reads the buffer when these commands have
/// finished, and does not wait for them unless asked to. The buffer must be used only on the OpenGL thread.
class Readback {
  public:
    Readback() = default;
    ~Readback() { release(); }
    Readback(const Readback&) = delete;
    Readback& operator=(const Readback&) = delete;

    /// Allocates the buffer. Returns false if the buffer cannot be mapped.
    bool allocate(const char* label, std::size_t words);
    void release();
    /// Whether the buffer is allocated.
    explicit operator bool() const { return !words_.empty(); }
    GLuint id() const { return buffer_.id(); }

    /// Marks the end of the commands that fill the buffer.
    void begin();
    /// Whether the commands that fill the buffer may still be running; if so, the buffer must not be refilled
    /// yet.
    bool pending() const { return fence_ != nullptr; }
    /// Returns the words once, after the commands have finished. With `wait`, waits up to ten seconds.
    std::optional<std::span<const std::uint32_t>> take(bool wait);

  private:
    Buffer buffer_;
    std::span<const std::uint32_t> words_;
    GLsync fence_ = nullptr;
};

}  // namespace vantage::gl
