#include "base/gl/context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "base/gl/failure.h"

namespace vantage::gl {
namespace {

EGLContext context_on(EGLDisplay display, Debug debug) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_CONTEXT;
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 debug == Debug::on ? EGL_CONTEXT_OPENGL_DEBUG : EGL_NONE,
                                 EGL_TRUE,
                                 EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

bool has_extension(const char* list, const char* name) { return list && std::strstr(list, name); }

/// libepoxy terminates the process if it cannot load a library, so loading is tested first.
bool loads(const char* library) { return ::dlopen(library, RTLD_LAZY | RTLD_LOCAL) != nullptr; }

/// The OpenGL libraries that cannot be loaded; empty if all of them can.
std::string missing_libraries() {
    if (!loads("libEGL.so.1")) return "libEGL.so.1";
    return loads("libOpenGL.so.0") || loads("libGL.so.1") ? "" : "libOpenGL.so.0 or libGL.so.1";
}

struct Devices {
    std::vector<EGLDeviceEXT> hardware, software;
};

Devices listed_devices() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_extension(client, "EGL_EXT_platform_device") ||
        !has_extension(client, "EGL_EXT_device_enumeration"))
        return {};
    std::array<EGLDeviceEXT, 16> found{};
    EGLint n = 0;
    if (!eglQueryDevicesEXT(EGLint(found.size()), found.data(), &n)) return {};
    Devices out;
    for (EGLint i = 0; i < n; ++i) {
        const char* extensions = eglQueryDeviceStringEXT(found[std::size_t(i)], EGL_EXTENSIONS);
        (has_extension(extensions, "EGL_MESA_device_software") ? out.software : out.hardware)
            .push_back(found[std::size_t(i)]);
    }
    return out;
}

/// The EGL devices, hardware before software. EGL devices make a GPU available even without a display server.
std::vector<EGLDeviceEXT> hardware_first() {
    Devices all = listed_devices();
    all.hardware.insert(all.hardware.end(), all.software.begin(), all.software.end());
    return all.hardware;
}

}  // namespace

Debug debug_from_environment() {
    const char* value = std::getenv("VANTAGE_DEBUG_GL");
    return value && std::strcmp(value, "0") != 0 ? Debug::on : Debug::off;
}

bool has_hardware() { return missing_libraries().empty() && !listed_devices().hardware.empty(); }

struct HeadlessContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    /// Creates a context on this display and makes it current; false if that fails.
    bool adopt(EGLDisplay candidate, Debug debug) {
        const EGLContext made = context_on(candidate, debug);
        if (made == EGL_NO_CONTEXT) return false;
        if (!eglMakeCurrent(candidate, EGL_NO_SURFACE, EGL_NO_SURFACE, made)) {
            eglDestroyContext(candidate, made);
            return false;
        }
        display = candidate;
        context = made;
        return true;
    }

    bool adopt_any(Debug debug) {
        for (EGLDeviceEXT device : hardware_first())
            if (adopt(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr), debug)) return true;
        return has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS),
                             "EGL_MESA_platform_surfaceless") &&
               adopt(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
                     debug);
    }
};

HeadlessContext::HeadlessContext(Debug debug) : state_(std::make_unique<State>()) {
    if (const std::string missing = missing_libraries(); !missing.empty())
        throw Failure("no OpenGL: cannot load " + missing + " (packages libegl1 and libopengl0)");
    if (!state_->adopt_any(debug))
        throw Failure("no OpenGL 4.5 core context through EGL (tried every device, then surfaceless)");
    if (debug == Debug::on) watch_errors();
}

HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;

HeadlessContext::~HeadlessContext() {
    if (!state_ || state_->context == EGL_NO_CONTEXT) return;
    // The display stays initialized: terminating it unloads the driver, whose memory is then reported as
    // leaked.
    eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(state_->display, state_->context);
}

Device current_device() {
    const auto text = [](GLenum name) {
        const GLubyte* s = glGetString(name);
        return std::string(s ? reinterpret_cast<const char*>(s) : "");
    };
    Device d{text(GL_RENDERER), text(GL_VERSION)};
    for (const char* soft : {"llvmpipe", "softpipe", "swrast", "Software"})
        d.software |= d.renderer.find(soft) != std::string::npos;
    return d;
}

namespace {

/// The first serious message since the last check(). The message is stored because exceptions must not
/// propagate through the driver.
thread_local std::string pending;

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text,
                           const void*) {
    if ((severity == GL_DEBUG_SEVERITY_HIGH || type == GL_DEBUG_TYPE_ERROR) && pending.empty())
        pending = text;
}

}  // namespace

void watch_errors() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

void forget_errors() {
    pending.clear();
    while (glGetError() != GL_NO_ERROR) {
    }
}

void check(const char* where) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR && pending.empty()) return;
    const std::string text = std::exchange(pending, {});
    forget_errors();
    throw Failure(std::string("OpenGL failed in ") + where + ": " +
                  (text.empty() ? "error " + std::to_string(error) : text));
}

}  // namespace vantage::gl
