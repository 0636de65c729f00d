#include "player/headset/runtime/shared_context.h"

#include <epoxy/egl.h>
#include <epoxy/glx.h>

#include "base/gl/context.h"

namespace vantage {

SharedContext::SharedContext() : egl_(eglGetCurrentContext() != EGL_NO_CONTEXT) {
    if (egl_) {
        display_ = eglGetCurrentDisplay();
        context_ = eglGetCurrentContext();
        draw_ = eglGetCurrentSurface(EGL_DRAW);
        read_ = eglGetCurrentSurface(EGL_READ);
        return;
    }
    display_ = glXGetCurrentDisplay();
    context_ = glXGetCurrentContext();
    drawable_ = glXGetCurrentDrawable();
}

SharedContext::~SharedContext() {
    if (egl_ && eglGetCurrentContext() != context_) eglMakeCurrent(display_, draw_, read_, context_);
    if (!egl_ && glXGetCurrentContext() != context_)
        glXMakeCurrent(static_cast<Display*>(display_), drawable_, static_cast<GLXContext>(context_));
    gl::forget_errors();
}

}  // namespace vantage
