#include "player/panels/growing_buffer.h"

#include <bit>
#include <stdexcept>

namespace vantage {

void GrowingBuffer::begin(std::size_t bytes) {
    used_ = 0;
    if (bytes <= room_) {
        if (buffer_) glInvalidateBufferData(buffer_.id());  // draws in progress keep the old data
        return;
    }
    room_ = std::bit_ceil(bytes);
    buffer_ = gl::make_buffer(label_, room_, nullptr, GL_DYNAMIC_STORAGE_BIT);
}

void GrowingBuffer::write(std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    if (bytes.size() > room_ - used_)
        throw std::logic_error("more bytes are written to a buffer than it can hold");
    glNamedBufferSubData(buffer_.id(), GLintptr(used_), GLsizeiptr(bytes.size()), bytes.data());
    used_ += bytes.size();
}

}  // namespace vantage
