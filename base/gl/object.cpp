#include "base/gl/object.h"

#include <unordered_map>

#include "base/gl/failure.h"

namespace vantage::gl {
namespace {

/// The sizes in bytes of live objects, by name, on the context's thread. In OpenGL, a texture and a buffer
/// may have the same name.
struct Ledger {
    std::unordered_map<GLuint, std::uint64_t> textures, buffers;
    std::uint64_t held = 0;
};
thread_local Ledger ledger;

void record(std::unordered_map<GLuint, std::uint64_t>& sizes, GLuint id, std::uint64_t bytes) {
    sizes[id] = bytes;
    ledger.held += bytes;
}

void forget(std::unordered_map<GLuint, std::uint64_t>& sizes, GLuint id) {
    if (const auto it = sizes.find(id); it != sizes.end()) {
        ledger.held -= it->second;
        sizes.erase(it);
    }
}

std::uint64_t texel_bytes(GLuint texture) {
    std::uint64_t bits = 0;
    for (const GLenum part : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                              GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE}) {
        GLint size = 0;
        glGetTextureLevelParameteriv(texture, 0, part, &size);
        bits += std::uint64_t(size);
    }
    return (bits + 7) / 8;
}

}  // namespace

std::uint64_t memory_held() { return ledger.held; }

void release_buffer(GLuint id) {
    forget(ledger.buffers, id);
    glDeleteBuffers(1, &id);
}

void release_texture(GLuint id) {
    forget(ledger.textures, id);
    glDeleteTextures(1, &id);
}

Buffer make_buffer(const char* label, std::size_t bytes, const void* data, GLbitfield flags) {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    glNamedBufferStorage(id, GLsizeiptr(bytes > 0 ? bytes : 4), data, flags);
    record(ledger.buffers, id, bytes);
    glObjectLabel(GL_BUFFER, id, -1, label);
    return Buffer(id);
}

namespace {
void set_sampling(GLuint id, GLenum filter) {
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GLint(filter));
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GLint(filter));
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}
}  // namespace

Texture make_texture_2d(const char* label, GLenum format, int width, int height, GLenum filter) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &id);
    glTextureStorage2D(id, 1, format, width, height);
    record(ledger.textures, id, std::uint64_t(width) * std::uint64_t(height) * texel_bytes(id));
    set_sampling(id, filter);
    glObjectLabel(GL_TEXTURE, id, -1, label);
    return Texture(id);
}

Texture make_texture_array(const char* label, GLenum format, int width, int height, int layers,
                           GLenum filter) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
    glTextureStorage3D(id, 1, format, width, height, layers);
    record(ledger.textures, id,
           std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(layers) * texel_bytes(id));
    set_sampling(id, filter);
    glObjectLabel(GL_TEXTURE, id, -1, label);
    return Texture(id);
}

Texture make_layer_view(const char* label, const Texture& array, GLenum format, int layer) {
    GLuint id = 0;
    glGenTextures(1, &id);  // a view needs a name that is not yet a texture
    glTextureView(id, GL_TEXTURE_2D, array.id(), format, 0, 1, GLuint(layer), 1);
    set_sampling(id, GL_NEAREST);
    glObjectLabel(GL_TEXTURE, id, -1, label);
    return Texture(id);
}

Framebuffer make_framebuffer(const char* label, std::span<const GLuint> colors, GLuint depth) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    Framebuffer framebuffer(id);
    GLenum buffers[8];
    for (std::size_t i = 0; i < colors.size(); ++i) {
        buffers[i] = GLenum(GL_COLOR_ATTACHMENT0 + i);
        glNamedFramebufferTexture(id, buffers[i], colors[i], 0);
    }
    if (colors.empty())
        glNamedFramebufferDrawBuffer(id, GL_NONE);
    else
        glNamedFramebufferDrawBuffers(id, GLsizei(colors.size()), buffers);
    if (depth) glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth, 0);
    glObjectLabel(GL_FRAMEBUFFER, id, -1, label);
    if (glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Failure(std::string("framebuffer '") + label + "' is incomplete");
    return framebuffer;
}

Framebuffer make_layer_framebuffer(const char* label, const Texture& array, int layer) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    Framebuffer framebuffer(id);
    glNamedFramebufferTextureLayer(id, GL_COLOR_ATTACHMENT0, array.id(), 0, layer);
    glNamedFramebufferDrawBuffer(id, GL_COLOR_ATTACHMENT0);
    glObjectLabel(GL_FRAMEBUFFER, id, -1, label);
    if (glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Failure(std::string("framebuffer '") + label + "' is incomplete");
    return framebuffer;
}

VertexArray make_vertex_array(const char* label) {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    glObjectLabel(GL_VERTEX_ARRAY, id, -1, label);
    return VertexArray(id);
}

Query make_query(GLenum target) {
    GLuint id = 0;
    glCreateQueries(target, 1, &id);
    return Query(id);
}

void attach_floats(const VertexArray& vao, GLuint attribute, const Buffer& buffer, int components,
                   int stride) {
    glVertexArrayVertexBuffer(vao.id(), attribute, buffer.id(), 0, stride);
    glVertexArrayAttribFormat(vao.id(), attribute, components, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vao.id(), attribute, attribute);
    glEnableVertexArrayAttrib(vao.id(), attribute);
}

}  // namespace vantage::gl
