// An OpenXR runtime without a headset, for tests. It plays a scenario (scenario.h), saves the pictures that a
// program draws, and records each call that violates the specification (record.h). Select it with
// XR_RUNTIME_JSON, the path of its manifest.
#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <optional>

#include "tests/openxr/calls.h"
#include "tests/openxr/calls/checks.h"
#include "tests/openxr/calls/handles.h"
#include "tests/openxr/one_call.h"
#include "tests/openxr/openxr_gl.h"
#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

/// A string that can be a template argument.
template <std::size_t n>
struct Name {
    char text[n];
    constexpr Name(const char (&t)[n]) { std::copy_n(t, n, text); }
};

/// An entry point for the program: runs `function` exclusively and returns failures as results.
template <Name name, auto function>
struct Call;
template <Name name, class... Arguments, XrResult (*function)(Arguments...)>
struct Call<name, function> {
    static XrResult XRAPI_CALL call(Arguments... arguments) {
        const std::scoped_lock lock(one_call());
        set_current_call(name.text);
        try {
            if (const std::optional<XrResult> forced = take_forced_result(name.text)) return *forced;
            return function(arguments...);
        } catch (const Ended& ended) {
            return ended.result;
        } catch (const std::bad_alloc&) {
            return XR_ERROR_OUT_OF_MEMORY;
        }
    }
};

struct Function {
    const char* name;
    PFN_xrVoidFunction call;
    bool needs_instance = true;
    const char* extension = nullptr;
};

/// `Type`: the declaration in the specification, which the compiler compares with the type of `function`.
template <class Type, Name name, auto function>
Function entry(bool needs_instance = true, const char* extension = nullptr) {
    const Type call = &Call<name, function>::call;
    return {name.text, reinterpret_cast<PFN_xrVoidFunction>(call), needs_instance, extension};
}

XrResult XRAPI_CALL get_instance_proc_addr(XrInstance instance, const char* name, PFN_xrVoidFunction* out);
XrResult XRAPI_CALL enumerate_no_layers(uint32_t, uint32_t* count, XrApiLayerProperties*) {
    *count = 0;
    return XR_SUCCESS;
}

#define CORE(name, function) entry<PFN_##name, #name, function>()

const auto& functions() {
    static const std::array all = {
        Function{"xrGetInstanceProcAddr", reinterpret_cast<PFN_xrVoidFunction>(get_instance_proc_addr),
                 false},
        Function{"xrEnumerateApiLayerProperties", reinterpret_cast<PFN_xrVoidFunction>(enumerate_no_layers),
                 false},
        entry<PFN_xrEnumerateInstanceExtensionProperties, "xrEnumerateInstanceExtensionProperties",
              enumerate_instance_extensions>(false),
        entry<PFN_xrCreateInstance, "xrCreateInstance", create_instance>(false),
        CORE(xrDestroyInstance, destroy_instance),
        CORE(xrGetInstanceProperties, get_instance_properties),
        CORE(xrPollEvent, poll_event),
        CORE(xrResultToString, result_to_string),
        CORE(xrStructureTypeToString, structure_type_to_string),
        CORE(xrStringToPath, string_to_path),
        CORE(xrPathToString, path_to_string),
        CORE(xrGetSystem, get_system),
        CORE(xrGetSystemProperties, get_system_properties),
        CORE(xrEnumerateEnvironmentBlendModes, enumerate_blend_modes),
        CORE(xrEnumerateViewConfigurations, enumerate_view_configurations),
        CORE(xrGetViewConfigurationProperties, get_view_configuration_properties),
        CORE(xrEnumerateViewConfigurationViews, enumerate_view_configuration_views),
        CORE(xrCreateSession, create_session),
        CORE(xrDestroySession, destroy_session),
        CORE(xrBeginSession, begin_session),
        CORE(xrEndSession, end_session),
        CORE(xrRequestExitSession, request_exit_session),
        CORE(xrEnumerateReferenceSpaces, enumerate_reference_spaces),
        CORE(xrCreateReferenceSpace, create_reference_space),
        CORE(xrGetReferenceSpaceBoundsRect, get_bounds),
        CORE(xrCreateActionSpace, create_action_space),
        CORE(xrLocateSpace, locate_space),
        CORE(xrDestroySpace, destroy_space),
        CORE(xrLocateViews, locate_views),
        CORE(xrEnumerateSwapchainFormats, enumerate_swapchain_formats),
        CORE(xrCreateSwapchain, create_swapchain),
        CORE(xrDestroySwapchain, destroy_swapchain),
        CORE(xrEnumerateSwapchainImages, enumerate_swapchain_images),
        CORE(xrAcquireSwapchainImage, acquire_image),
        CORE(xrWaitSwapchainImage, wait_image),
        CORE(xrReleaseSwapchainImage, release_image),
        CORE(xrWaitFrame, wait_frame),
        CORE(xrBeginFrame, begin_frame),
        CORE(xrEndFrame, end_frame),
        CORE(xrCreateActionSet, create_action_set),
        CORE(xrDestroyActionSet, destroy_action_set),
        CORE(xrCreateAction, create_action),
        CORE(xrDestroyAction, destroy_action),
        CORE(xrSuggestInteractionProfileBindings, suggest_bindings),
        CORE(xrAttachSessionActionSets, attach_action_sets),
        CORE(xrSyncActions, sync_actions),
        CORE(xrGetCurrentInteractionProfile, get_current_profile),
        CORE(xrGetActionStateBoolean, get_boolean),
        CORE(xrGetActionStateFloat, get_float),
        CORE(xrGetActionStateVector2f, get_vector),
        CORE(xrGetActionStatePose, get_pose),
        CORE(xrEnumerateBoundSourcesForAction, enumerate_bound_sources),
        CORE(xrGetInputSourceLocalizedName, get_source_name),
        CORE(xrApplyHapticFeedback, apply_haptics),
        CORE(xrStopHapticFeedback, stop_haptics),
        entry<PFN_xrGetOpenGLGraphicsRequirementsKHR, "xrGetOpenGLGraphicsRequirementsKHR",
              get_opengl_requirements>(true, XR_KHR_OPENGL_ENABLE_EXTENSION_NAME),
    };
    return all;
}

#undef CORE

XrResult XRAPI_CALL get_instance_proc_addr(XrInstance instance, const char* name, PFN_xrVoidFunction* out) {
    const std::scoped_lock lock(one_call());
    if (!name || !out) return XR_ERROR_VALIDATION_FAILURE;
    *out = nullptr;
    const auto found = std::find_if(functions().begin(), functions().end(),
                                    [&](const Function& f) { return std::strcmp(f.name, name) == 0; });
    if (found == functions().end()) return XR_ERROR_FUNCTION_UNSUPPORTED;
    const Instance* const of = handles().instances.find(instance);
    if (found->needs_instance && !of) return XR_ERROR_HANDLE_INVALID;
    if (found->extension && !of->extensions.contains(found->extension)) return XR_ERROR_FUNCTION_UNSUPPORTED;
    *out = found->call;
    return XR_SUCCESS;
}

}  // namespace

std::mutex& one_call() {
    static std::mutex& mutex = *new std::mutex;
    return mutex;
}

}  // namespace test_runtime

// Version negotiation between the loader and the runtime. The loader's header is not installed with OpenXR's
// headers.
extern "C" {

struct XrNegotiateLoaderInfo {
    int32_t structure;  ///< 1
    uint32_t version;   ///< 1
    size_t size;
    uint32_t first_interface, last_interface;
    XrVersion first_api, last_api;
};

struct XrNegotiateRuntimeRequest {
    int32_t structure;  ///< 3
    uint32_t version;   ///< 1
    size_t size;
    uint32_t interface;
    XrVersion api;
    PFN_xrGetInstanceProcAddr get_instance_proc_addr;
};

__attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(
    const XrNegotiateLoaderInfo* loader, XrNegotiateRuntimeRequest* request) {
    if (!loader || loader->structure != 1 || loader->size != sizeof *loader || !request ||
        request->structure != 3 || request->size != sizeof *request || loader->first_interface > 1 ||
        loader->last_interface < 1)
        return XR_ERROR_INITIALIZATION_FAILED;
    request->interface = 1;
    request->api = XR_CURRENT_API_VERSION;
    request->get_instance_proc_addr = test_runtime::get_instance_proc_addr;
    return XR_SUCCESS;
}
}
