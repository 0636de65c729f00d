#include "player/headset/runtime/graphics_session.h"

#include <string>

#include "base/text/error.h"
#include "player/headset/runtime/openxr_graphics.h"
#include "player/headset/runtime/shared_context.h"
#include "player/headset/runtime/xr_result.h"

namespace vantage {
namespace {

/// The configuration that a GLX context was created with.
GLXFBConfig configuration_of(Display* display, GLXContext context) {
    int id = 0, screen = 0, count = 0;
    glXQueryContext(display, context, GLX_FBCONFIG_ID, &id);
    glXQueryContext(display, context, GLX_SCREEN, &screen);
    const int wanted[] = {GLX_FBCONFIG_ID, id, 0};
    GLXFBConfig* found = glXChooseFBConfig(display, screen, wanted, &count);
    const GLXFBConfig out = count > 0 ? found[0] : nullptr;
    if (found) XFree(found);
    if (!out) throw Error(Exit::graphics, "headset: the window's GLX configuration was not found");
    return out;
}

EGLConfig egl_configuration_of(EGLDisplay display, EGLContext context) {
    EGLint id = 0, count = 0;
    eglQueryContext(display, context, EGL_CONFIG_ID, &id);
    const EGLint wanted[] = {EGL_CONFIG_ID, id, EGL_NONE};
    EGLConfig out = nullptr;
    eglChooseConfig(display, wanted, &out, 1, &count);  // none for a context without a configuration
    return out;
}

std::string text_of(XrVersion v) {
    return std::to_string(XR_VERSION_MAJOR(v)) + "." + std::to_string(XR_VERSION_MINOR(v));
}

XrGraphicsBindingOpenGLXlibKHR glx_binding() {
    auto out = typed<XrGraphicsBindingOpenGLXlibKHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
    out.xDisplay = glXGetCurrentDisplay();
    out.glxContext = glXGetCurrentContext();
    out.glxDrawable = glXGetCurrentDrawable();
    out.glxFBConfig = configuration_of(out.xDisplay, out.glxContext);
    if (XVisualInfo* visual = glXGetVisualFromFBConfig(out.xDisplay, out.glxFBConfig)) {
        out.visualid = std::uint32_t(visual->visualid);
        XFree(visual);
    }
    return out;
}

XrGraphicsBindingEGLMNDX egl_binding() {
    auto out = typed<XrGraphicsBindingEGLMNDX>(XR_TYPE_GRAPHICS_BINDING_EGL_MNDX);
    out.getProcAddress = reinterpret_cast<decltype(out.getProcAddress)>(eglGetProcAddress);
    out.display = eglGetCurrentDisplay();
    out.context = eglGetCurrentContext();
    out.config = egl_configuration_of(out.display, out.context);
    return out;
}

/// Queries the versions of OpenGL that the runtime supports, as required before creating a session. Throws
/// Error(graphics) if this context's version is not one of them.
void expect_version(XrInstance instance, XrSystemId system) {
    PFN_xrGetOpenGLGraphicsRequirementsKHR requirements = nullptr;
    expect(xrGetInstanceProcAddr(instance, "xrGetOpenGLGraphicsRequirementsKHR",
                                 reinterpret_cast<PFN_xrVoidFunction*>(&requirements)),
           "xrGetInstanceProcAddr");
    auto limits = typed<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    expect(requirements(instance, system, &limits), "xrGetOpenGLGraphicsRequirementsKHR");
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    const XrVersion has = XR_MAKE_VERSION(major, minor, 0);
    // The maximum is the newest version that the runtime was tested with; newer versions work as well.
    if (has < XR_MAKE_VERSION(XR_VERSION_MAJOR(limits.minApiVersionSupported),
                              XR_VERSION_MINOR(limits.minApiVersionSupported), 0))
        throw Error(Exit::graphics, "headset: the OpenXR runtime needs OpenGL " +
                                        text_of(limits.minApiVersionSupported) + ", and this is " +
                                        text_of(has));
}

}  // namespace

XrSession make_session(const XrRuntime& runtime, XrSystemId system) {
    expect_version(runtime.get(), system);
    auto info = typed<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    info.systemId = system;
    XrSession out = XR_NULL_HANDLE;
    const auto create = [&](const auto& binding) {
        info.next = &binding;
        const SharedContext shared;
        expect(xrCreateSession(runtime.get(), &info, &out), "xrCreateSession");
    };
    if (eglGetCurrentContext() == EGL_NO_CONTEXT)
        create(glx_binding());
    else if (runtime.extensions().egl)
        create(egl_binding());
    else
        throw Error(
            Exit::graphics,
            "headset: this OpenXR runtime needs an X display for OpenGL, but there is none (DISPLAY)");
    return out;
}

}  // namespace vantage
