#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_PLATFORM_EGL
#include "tests/openxr/graphics.h"

// Epoxy's headers must precede OpenXR's, which use their types.
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <epoxy/glx.h>
#include <openxr/openxr_platform.h>

#include <cstdio>

#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

/// Saves the program's pixel pack settings and restores them after reading.
class PackState {
  public:
    PackState() {
        for (std::size_t i = 0; i < std::size(names); ++i) {
            glGetIntegerv(names[i], &values_[i]);
            glPixelStorei(names[i], names[i] == GL_PACK_ALIGNMENT ? 1 : 0);
        }
        glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer_);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    }
    ~PackState() {
        for (std::size_t i = 0; i < std::size(names); ++i) glPixelStorei(names[i], values_[i]);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(buffer_));
    }
    PackState(const PackState&) = delete;
    PackState& operator=(const PackState&) = delete;

  private:
    static constexpr GLenum names[] = {GL_PACK_ALIGNMENT,   GL_PACK_ROW_LENGTH,  GL_PACK_SKIP_ROWS,
                                       GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES, GL_PACK_IMAGE_HEIGHT,
                                       GL_PACK_SWAP_BYTES,  GL_PACK_LSB_FIRST};
    GLint values_[std::size(names)] = {}, buffer_ = 0;
};

template <class T>
std::vector<T> texels_of(uint32_t texture, const XrRect2Di& rect, uint32_t layer, GLenum format, GLenum type,
                         std::size_t channels) {
    const PackState state;
    const auto [at, size] = rect;
    std::vector<T> out(std::size_t(size.width) * std::size_t(size.height) * channels);
    glGetTextureSubImage(texture, 0, at.x, at.y, GLint(layer), size.width, size.height, 1, format, type,
                         GLsizei(out.size() * sizeof(T)), out.data());
    return out;
}

void check_version() {
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    require(major > 4 || (major == 4 && minor >= 5), XR_ERROR_GRAPHICS_DEVICE_INVALID,
            "the context's version of OpenGL is older than required");
}

GraphicsContext context_in(const Instance& instance, const XrSessionCreateInfo& info) {
    if (const void* next = next_of_type(info.next, XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR)) {
        const auto& glx = *static_cast<const XrGraphicsBindingOpenGLXlibKHR*>(next);
        require(glx.xDisplay && glx.glxContext && glx.glxDrawable && glx.glxFBConfig,
                XR_ERROR_GRAPHICS_DEVICE_INVALID, "the graphics binding is incomplete");
        return {Platform::glx, glx.glxContext};
    }
    const void* const next = next_of_type(info.next, XR_TYPE_GRAPHICS_BINDING_EGL_MNDX);
    require(next, XR_ERROR_GRAPHICS_DEVICE_INVALID, "there is no graphics binding");
    require(instance.extensions.contains(XR_MNDX_EGL_ENABLE_EXTENSION_NAME), XR_ERROR_VALIDATION_FAILURE,
            "XR_MNDX_egl_enable is not enabled");
    const auto& egl = *static_cast<const XrGraphicsBindingEGLMNDX*>(next);
    require(egl.getProcAddress && egl.display && egl.context, XR_ERROR_GRAPHICS_DEVICE_INVALID,
            "the graphics binding is incomplete");
    return {Platform::egl, egl.context};
}

void clear(uint32_t texture, int64_t format) {
    const bool stencil = format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
    constexpr float magenta[] = {1, 0, 1, 1}, depth = 0;
    constexpr uint32_t depth_and_stencil[] = {0, 0};
    if (stencil && format == GL_DEPTH24_STENCIL8)
        glClearTexImage(texture, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, depth_and_stencil);
    else if (stencil)
        glClearTexImage(texture, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, depth_and_stencil);
    else if (is_depth(format))
        glClearTexImage(texture, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    else
        glClearTexImage(texture, 0, GL_RGBA, GL_FLOAT, magenta);
}

}  // namespace

GraphicsContext checked_context(const Instance& instance, const XrSessionCreateInfo& info) {
    const GraphicsContext out = context_in(instance, info);
    require(is_current(out), XR_ERROR_GRAPHICS_DEVICE_INVALID, "the context is not current");
    check_version();
    return out;
}

bool is_current(const GraphicsContext& graphics) {
    return graphics.context == (graphics.platform == Platform::glx
                                    ? static_cast<void*>(glXGetCurrentContext())
                                    : eglGetCurrentContext());
}

bool check_graphics(const Session& session) {
    if (!is_current(session.graphics)) {
        breach("the session's context is not current");
        return false;
    }
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
        char number[16];
        std::snprintf(number, sizeof number, "0x%04x", error);
        breach("there was an earlier OpenGL error, " + std::string(number));
    }
    return true;
}

void be_careless() {
    if (world().scenario.careless) glEnable(GL_INVALID_ENUM);
}

bool is_depth(int64_t format) {
    return format == GL_DEPTH_COMPONENT16 || format == GL_DEPTH_COMPONENT24 ||
           format == GL_DEPTH_COMPONENT32F || format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
}

std::vector<uint32_t> make_textures(const XrSwapchainCreateInfo& info, std::size_t count) {
    std::vector<uint32_t> out(count);
    const auto levels = GLsizei(info.mipCount), width = GLsizei(info.width), height = GLsizei(info.height);
    const bool array = info.arraySize > 1;
    glCreateTextures(array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, GLsizei(count), out.data());
    for (const uint32_t texture : out) {
        if (array)
            glTextureStorage3D(texture, levels, GLenum(info.format), width, height, GLsizei(info.arraySize));
        else
            glTextureStorage2D(texture, levels, GLenum(info.format), width, height);
        clear(texture, info.format);
    }
    return out;
}

void delete_textures(const std::vector<uint32_t>& textures) {
    glDeleteTextures(GLsizei(textures.size()), textures.data());
}

std::vector<uint8_t> colors_of(uint32_t texture, const XrRect2Di& rect, uint32_t layer) {
    return texels_of<uint8_t>(texture, rect, layer, GL_RGBA, GL_UNSIGNED_BYTE, 4);
}

std::vector<float> depths_of(uint32_t texture, const XrRect2Di& rect, uint32_t layer) {
    return texels_of<float>(texture, rect, layer, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
}

}  // namespace test_runtime
