#include "player/render/frame_ring.h"

#include <algorithm>
#include <stdexcept>

#include "base/gl/failure.h"

namespace vantage {
namespace {

constexpr std::size_t alignment = 256;  // the largest alignment that OpenGL may require of a buffer's offset
constexpr std::size_t aligned(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

}  // namespace

FrameRing::FrameRing(const char* label, std::size_t region_bytes)
    : region_bytes_(aligned(region_bytes)),
      fences_(std::clamp<std::size_t>((std::size_t(16) << 20) / region_bytes_, 4, 32), nullptr) {
    constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const std::size_t bytes = region_bytes_ * fences_.size();
    buffer_ = gl::make_buffer(label, bytes, nullptr, flags);
    mapped_ = static_cast<std::byte*>(glMapNamedBufferRange(buffer_.id(), 0, GLsizeiptr(bytes), flags));
    if (!mapped_) throw gl::Failure("the frame's buffer cannot be mapped");
}

FrameRing::~FrameRing() {
    for (const GLsync f : fences_)
        if (f) glDeleteSync(f);
    glUnmapNamedBuffer(buffer_.id());
}

void FrameRing::begin() {
    region_ = (region_ + 1) % fences_.size();
    used_ = 0;
    GLsync& fence = fences_[region_];
    if (!fence) return;
    constexpr GLuint64 second = 1'000'000'000;
    while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, second) == GL_TIMEOUT_EXPIRED) {
    }
    glDeleteSync(fence);
    fence = nullptr;
}

FrameRing::Space FrameRing::take(std::size_t bytes) {
    const std::size_t at = used_;
    used_ += aligned(std::max<std::size_t>(bytes, 1));
    if (used_ > region_bytes_) throw std::logic_error("a pass needs more constants than its region holds");
    const std::size_t offset = region_ * region_bytes_ + at;
    return {mapped_ + offset, GLintptr(offset), GLsizeiptr(std::max<std::size_t>(bytes, 4))};
}

void FrameRing::end() { fences_[region_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0); }

}  // namespace vantage
