#include "player/stream/upload_ring.h"

#include "base/gl/failure.h"

namespace vantage {

UploadRing::UploadRing(std::size_t bytes) : bytes_(bytes) {
    constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    buffer_ = gl::make_buffer("uploads", bytes_, nullptr, flags);
    mapped_ = static_cast<std::byte*>(glMapNamedBufferRange(buffer_.id(), 0, GLsizeiptr(bytes_), flags));
    if (!mapped_) throw gl::Failure("the upload buffer cannot be mapped");
}

UploadRing::~UploadRing() {
    for (const Fence& f : fences_) glDeleteSync(f.sync);
    glUnmapNamedBuffer(buffer_.id());
}

std::optional<UploadRing::Piece> UploadRing::take(std::size_t bytes) {
    constexpr std::size_t alignment = 256;
    const std::size_t wanted = (bytes + alignment - 1) / alignment * alignment;
    std::size_t at = head_;
    if (given_.empty()) {
        at = 0;
        if (wanted > bytes_) return std::nullopt;
    } else if (const std::size_t tail = given_.front().offset; head_ > tail) {
        if (at + wanted > bytes_) {  // no space at the end: continue at the start
            if (wanted > tail) return std::nullopt;
            at = 0;
        }
    } else if (at + wanted > tail) {
        return std::nullopt;
    }
    // A full ring, whose head and tail are at the same offset, would look empty.
    if (!given_.empty() && at + wanted == given_.front().offset) return std::nullopt;
    given_.push_back({at, wanted});
    head_ = at + wanted;
    return Piece{at, bytes, first_ + given_.size() - 1};
}

void UploadRing::release(const Piece& piece) {
    given_[std::size_t(piece.number - first_)].fence = next_fence_;
    released_ = true;
}

void UploadRing::fence() {
    if (released_) fences_.push_back({next_fence_++, glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)});
    released_ = false;
    while (!fences_.empty()) {
        const GLenum state = glClientWaitSync(fences_.front().sync, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
        if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) break;
        passed_ = fences_.front().number;
        glDeleteSync(fences_.front().sync);
        fences_.pop_front();
    }
    while (!given_.empty() && given_.front().fence && given_.front().fence <= passed_) {
        given_.pop_front();
        ++first_;
    }
}

}  // namespace vantage
