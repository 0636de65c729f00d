#include "tests/openxr/calls/session.h"

#include "tests/openxr/calls.h"
#include "tests/openxr/calls/events.h"
#include "tests/openxr/calls/system.h"
#include "tests/openxr/graphics.h"
#include "tests/openxr/openxr_gl.h"

namespace test_runtime {

std::vector<XrSession> sessions_of(XrInstance instance) {
    std::vector<XrSession> out;
    for (const auto& [handle, session] : handles().sessions)
        if (session.instance == instance) out.push_back(handle);
    return out;
}

void end_all_of(XrSession handle) {
    const Session& session = *handles().sessions.find(handle);
    const bool current = is_current(session.graphics);  // otherwise the textures are deleted with the context
    handles().swapchains.erase_if([&](const Swapchain& swapchain) {
        if (swapchain.session == handle && current) delete_textures(swapchain.textures);
        return swapchain.session == handle;
    });
    handles().spaces.erase_if([&](const Space& space) { return space.session == handle; });
    handles().sessions.erase(handle);
    note("session destroyed");
}

XrResult create_session(XrInstance handle, const XrSessionCreateInfo* info, XrSession* out) {
    const Instance& instance = instance_of(handle);
    check_struct(info, XR_TYPE_SESSION_CREATE_INFO,
                 {XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR, XR_TYPE_GRAPHICS_BINDING_EGL_MNDX});
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the session is null");
    require(info->createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "the flags are not 0");
    check_system(info->systemId);
    require(instance.extensions.contains(XR_KHR_OPENGL_ENABLE_EXTENSION_NAME), XR_ERROR_VALIDATION_FAILURE,
            "XR_KHR_opengl_enable is not enabled");
    require(instance.knows_requirements, XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING,
            "xrGetOpenGLGraphicsRequirementsKHR has not been called");
    const GraphicsContext graphics = checked_context(instance, *info);
    require(handles().sessions.empty(), XR_ERROR_LIMIT_REACHED, "a session already exists");
    Session session{};
    session.instance = handle;
    session.graphics = graphics;
    *out = handles().sessions.add(session);
    note("session created");
    set_state(*out, XR_SESSION_STATE_IDLE);
    set_state(*out, XR_SESSION_STATE_READY);
    return XR_SUCCESS;
}

XrResult destroy_session(XrSession handle) {
    live(handles().sessions, handle);
    end_all_of(handle);
    return XR_SUCCESS;
}

XrResult begin_session(XrSession handle, const XrSessionBeginInfo* info) {
    Session& session = session_of(handle);
    check_struct(info, XR_TYPE_SESSION_BEGIN_INFO);
    check_view_configuration(info->primaryViewConfigurationType);
    require(!session.running, XR_ERROR_SESSION_RUNNING, "the session is running");
    require(session.state == XR_SESSION_STATE_READY, XR_ERROR_SESSION_NOT_READY, "the session is not READY");
    session.running = true;
    session.ready_again = false;
    session.frames = 0;
    session.waited = session.begun = std::nullopt;
    note("session begun");
    return XR_SUCCESS;
}

XrResult end_session(XrSession handle) {
    Session& session = running_session(handle);
    require(session.state == XR_SESSION_STATE_STOPPING, XR_ERROR_SESSION_NOT_STOPPING,
            "the session is not STOPPING");
    session.running = false;
    note("session ended");
    set_state(handle, XR_SESSION_STATE_IDLE);
    set_state(handle, session.ready_again ? XR_SESSION_STATE_READY : XR_SESSION_STATE_EXITING);
    return XR_SUCCESS;
}

XrResult request_exit_session(XrSession handle) {
    Session& session = running_session(handle);
    note("exit requested");
    session.ready_again = false;
    walk_to(handle, XR_SESSION_STATE_STOPPING);
    return XR_SUCCESS;
}

}  // namespace test_runtime
