#pragma once
#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

/// Self-releasing OpenGL objects. These objects are move-only, are created with direct state access on the
/// context's thread, and are labeled for debuggers. The context must outlive them.
namespace vantage::gl {

template <auto Release>
class Handle {
  public:
    Handle() = default;
    explicit Handle(GLuint id) : id_(id) {}
    ~Handle() { reset(); }
    Handle(Handle&& o) noexcept : id_(std::exchange(o.id_, 0)) {}
    Handle& operator=(Handle&& o) noexcept {
        if (this != &o) {
            reset();
            id_ = std::exchange(o.id_, 0);
        }
        return *this;
    }
    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  private:
    void reset() {
        if (id_) Release(id_);
        id_ = 0;
    }
    GLuint id_ = 0;
};

void release_buffer(GLuint id);
void release_texture(GLuint id);
inline void release_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void release_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void release_query(GLuint id) { glDeleteQueries(1, &id); }
inline void release_program(GLuint id) { glDeleteProgram(id); }

using Buffer = Handle<&release_buffer>;
using Texture = Handle<&release_texture>;
using Framebuffer = Handle<&release_framebuffer>;
using VertexArray = Handle<&release_vertex_array>;
using Query = Handle<&release_query>;
using Program = Handle<&release_program>;

/// The total size in bytes of all live textures and buffers that the functions below created on this thread.
std::uint64_t memory_held();

/// A buffer with immutable storage of `bytes` bytes, copied from `data` or, if `data` is null, uninitialized.
/// `flags`: as for glNamedBufferStorage.
Buffer make_buffer(const char* label, std::size_t bytes, const void* data = nullptr, GLbitfield flags = 0);

/// A 2D texture with one level and immutable storage, clamped at its edges.
Texture make_texture_2d(const char* label, GLenum format, int width, int height, GLenum filter = GL_NEAREST);
/// An array texture with one level and immutable storage, clamped at its edges.
Texture make_texture_array(const char* label, GLenum format, int width, int height, int layers,
                           GLenum filter = GL_LINEAR);
/// One layer of an array texture of this format, as a 2D texture that shares its storage and keeps it alive.
Texture make_layer_view(const char* label, const Texture& array, GLenum format, int layer);
/// A framebuffer with the given color textures (in order of attachment, 8 at most) and depth texture (0 for
/// none). The framebuffer is layered if these are array textures. Throws Failure if the framebuffer is
/// incomplete.
Framebuffer make_framebuffer(const char* label, std::span<const GLuint> colors, GLuint depth);
/// A framebuffer with one layer of an array texture. Throws Failure if the framebuffer is incomplete.
Framebuffer make_layer_framebuffer(const char* label, const Texture& array, int layer);
VertexArray make_vertex_array(const char* label);
/// `target`: as for glCreateQueries.
Query make_query(GLenum target);

/// Feeds `attribute` with `components` floats per vertex from `buffer`, one vertex every `stride` bytes.
void attach_floats(const VertexArray& vao, GLuint attribute, const Buffer& buffer, int components,
                   int stride);

}  // namespace vantage::gl
