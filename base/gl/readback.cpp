#include "base/gl/readback.h"

namespace vantage::gl {

bool Readback::allocate(const char* label, std::size_t words) {
    release();
    constexpr GLbitfield flags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    buffer_ = make_buffer(label, 4 * words, nullptr, flags);
    const void* mapped = glMapNamedBufferRange(buffer_.id(), 0, GLsizeiptr(4 * words), flags);
    if (!mapped) return false;
    words_ = {static_cast<const std::uint32_t*>(mapped), words};
    return true;
}

void Readback::release() {
    if (fence_) glDeleteSync(fence_);
    fence_ = nullptr;
    words_ = {};
    buffer_ = {};
}

void Readback::begin() {
    if (!fence_) fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

std::optional<std::span<const std::uint32_t>> Readback::take(bool wait) {
    if (!fence_) return std::nullopt;
    constexpr GLuint64 second = 1'000'000'000;
    const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? 10 * second : 0);
    if (state == GL_TIMEOUT_EXPIRED) return std::nullopt;
    glDeleteSync(fence_);
    fence_ = nullptr;
    return words_;
}

}  // namespace vantage::gl
