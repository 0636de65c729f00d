#pragma once
// Implementations of the OpenXR functions. runtime.cpp maps them to their names in the specification.
#include <openxr/openxr.h>

struct XrGraphicsRequirementsOpenGLKHR;

namespace test_runtime {

// instance.cpp
XrResult enumerate_instance_extensions(const char*, uint32_t, uint32_t*, XrExtensionProperties*);
XrResult create_instance(const XrInstanceCreateInfo*, XrInstance*);
XrResult destroy_instance(XrInstance);
XrResult get_instance_properties(XrInstance, XrInstanceProperties*);
XrResult result_to_string(XrInstance, XrResult, char*);
XrResult structure_type_to_string(XrInstance, XrStructureType, char*);
XrResult string_to_path(XrInstance, const char*, XrPath*);
XrResult path_to_string(XrInstance, XrPath, uint32_t, uint32_t*, char*);

// system.cpp
XrResult get_system(XrInstance, const XrSystemGetInfo*, XrSystemId*);
XrResult get_system_properties(XrInstance, XrSystemId, XrSystemProperties*);
XrResult enumerate_blend_modes(XrInstance, XrSystemId, XrViewConfigurationType, uint32_t, uint32_t*,
                               XrEnvironmentBlendMode*);
XrResult enumerate_view_configurations(XrInstance, XrSystemId, uint32_t, uint32_t*, XrViewConfigurationType*);
XrResult get_view_configuration_properties(XrInstance, XrSystemId, XrViewConfigurationType,
                                           XrViewConfigurationProperties*);
XrResult enumerate_view_configuration_views(XrInstance, XrSystemId, XrViewConfigurationType, uint32_t,
                                            uint32_t*, XrViewConfigurationView*);
XrResult get_opengl_requirements(XrInstance, XrSystemId, XrGraphicsRequirementsOpenGLKHR*);

// events.cpp
XrResult poll_event(XrInstance, XrEventDataBuffer*);

// session.cpp
XrResult create_session(XrInstance, const XrSessionCreateInfo*, XrSession*);
XrResult destroy_session(XrSession);
XrResult begin_session(XrSession, const XrSessionBeginInfo*);
XrResult end_session(XrSession);
XrResult request_exit_session(XrSession);

// spaces.cpp
XrResult enumerate_reference_spaces(XrSession, uint32_t, uint32_t*, XrReferenceSpaceType*);
XrResult create_reference_space(XrSession, const XrReferenceSpaceCreateInfo*, XrSpace*);
XrResult get_bounds(XrSession, XrReferenceSpaceType, XrExtent2Df*);
XrResult create_action_space(XrSession, const XrActionSpaceCreateInfo*, XrSpace*);
XrResult locate_space(XrSpace, XrSpace, XrTime, XrSpaceLocation*);
XrResult destroy_space(XrSpace);
XrResult locate_views(XrSession, const XrViewLocateInfo*, XrViewState*, uint32_t, uint32_t*, XrView*);

// swapchain.cpp
XrResult enumerate_swapchain_formats(XrSession, uint32_t, uint32_t*, int64_t*);
XrResult create_swapchain(XrSession, const XrSwapchainCreateInfo*, XrSwapchain*);
XrResult destroy_swapchain(XrSwapchain);
XrResult enumerate_swapchain_images(XrSwapchain, uint32_t, uint32_t*, XrSwapchainImageBaseHeader*);
XrResult acquire_image(XrSwapchain, const XrSwapchainImageAcquireInfo*, uint32_t*);
XrResult wait_image(XrSwapchain, const XrSwapchainImageWaitInfo*);
XrResult release_image(XrSwapchain, const XrSwapchainImageReleaseInfo*);

// frame.cpp
XrResult wait_frame(XrSession, const XrFrameWaitInfo*, XrFrameState*);
XrResult begin_frame(XrSession, const XrFrameBeginInfo*);
XrResult end_frame(XrSession, const XrFrameEndInfo*);

// actions.cpp
XrResult create_action_set(XrInstance, const XrActionSetCreateInfo*, XrActionSet*);
XrResult destroy_action_set(XrActionSet);
XrResult create_action(XrActionSet, const XrActionCreateInfo*, XrAction*);
XrResult destroy_action(XrAction);
XrResult suggest_bindings(XrInstance, const XrInteractionProfileSuggestedBinding*);
XrResult attach_action_sets(XrSession, const XrSessionActionSetsAttachInfo*);

// input.cpp
XrResult sync_actions(XrSession, const XrActionsSyncInfo*);
XrResult get_current_profile(XrSession, XrPath, XrInteractionProfileState*);
XrResult get_boolean(XrSession, const XrActionStateGetInfo*, XrActionStateBoolean*);
XrResult get_float(XrSession, const XrActionStateGetInfo*, XrActionStateFloat*);
XrResult get_vector(XrSession, const XrActionStateGetInfo*, XrActionStateVector2f*);
XrResult get_pose(XrSession, const XrActionStateGetInfo*, XrActionStatePose*);
XrResult enumerate_bound_sources(XrSession, const XrBoundSourcesForActionEnumerateInfo*, uint32_t, uint32_t*,
                                 XrPath*);
XrResult get_source_name(XrSession, const XrInputSourceLocalizedNameGetInfo*, uint32_t, uint32_t*, char*);
XrResult apply_haptics(XrSession, const XrHapticActionInfo*, const XrHapticBaseHeader*);
XrResult stop_haptics(XrSession, const XrHapticActionInfo*);

}  // namespace test_runtime
