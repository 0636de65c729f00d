#include "tests/openxr/calls/system.h"

#include "tests/openxr/calls.h"
#include "tests/openxr/openxr_gl.h"
#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

constexpr XrSystemId the_system = 1;

}  // namespace

void check_system(XrSystemId system) {
    require(system == the_system, XR_ERROR_SYSTEM_INVALID, "the system does not exist");
}

void check_view_configuration(XrViewConfigurationType type) {
    require(type == XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED,
            "only the stereo view configuration is supported");
}

XrResult get_system(XrInstance handle, const XrSystemGetInfo* info, XrSystemId* out) {
    instance_of(handle);
    check_struct(info, XR_TYPE_SYSTEM_GET_INFO);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the system is null");
    require(info->formFactor == XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY, XR_ERROR_FORM_FACTOR_UNSUPPORTED,
            "only the form factor of a head-mounted display is supported");
    *out = the_system;
    return XR_SUCCESS;
}

XrResult get_system_properties(XrInstance handle, XrSystemId system, XrSystemProperties* out) {
    instance_of(handle);
    check_system(system);
    check_struct(out, XR_TYPE_SYSTEM_PROPERTIES);
    constexpr std::string_view name = "Test headset";
    out->systemId = system;
    out->vendorId = 0;
    out->systemName[name.copy(out->systemName, XR_MAX_SYSTEM_NAME_SIZE - 1)] = '\0';
    out->graphicsProperties = {max_swapchain_side, max_swapchain_side, max_layers};
    out->trackingProperties = {XR_TRUE, XR_TRUE};
    return XR_SUCCESS;
}

XrResult enumerate_blend_modes(XrInstance handle, XrSystemId system, XrViewConfigurationType type,
                               uint32_t capacity, uint32_t* count, XrEnvironmentBlendMode* out) {
    instance_of(handle);
    check_system(system);
    check_view_configuration(type);
    return fill(capacity, count, out, world().scenario.blend_modes);
}

XrResult enumerate_view_configurations(XrInstance handle, XrSystemId system, uint32_t capacity,
                                       uint32_t* count, XrViewConfigurationType* out) {
    instance_of(handle);
    check_system(system);
    return fill(capacity, count, out, std::vector{XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO});
}

XrResult get_view_configuration_properties(XrInstance handle, XrSystemId system, XrViewConfigurationType type,
                                           XrViewConfigurationProperties* out) {
    instance_of(handle);
    check_system(system);
    check_view_configuration(type);
    check_struct(out, XR_TYPE_VIEW_CONFIGURATION_PROPERTIES);
    out->viewConfigurationType = type;
    out->fovMutable = XR_TRUE;
    return XR_SUCCESS;
}

XrResult enumerate_view_configuration_views(XrInstance handle, XrSystemId system,
                                            XrViewConfigurationType type, uint32_t capacity, uint32_t* count,
                                            XrViewConfigurationView* out) {
    instance_of(handle);
    check_system(system);
    check_view_configuration(type);
    const std::array<Eye, 2>& eyes = world().scenario.eyes;
    return fill_structs(capacity, count, out, eyes.size(), XR_TYPE_VIEW_CONFIGURATION_VIEW,
                        [&](XrViewConfigurationView& view, std::size_t i) {
                            view.recommendedImageRectWidth = eyes[i].width;
                            view.recommendedImageRectHeight = eyes[i].height;
                            view.maxImageRectWidth = view.maxImageRectHeight = max_swapchain_side;
                            view.recommendedSwapchainSampleCount = view.maxSwapchainSampleCount = 1;
                        });
}

XrResult get_opengl_requirements(XrInstance handle, XrSystemId system, XrGraphicsRequirementsOpenGLKHR* out) {
    Instance& instance = instance_of(handle);
    check_system(system);
    check_struct(out, XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    out->minApiVersionSupported = XR_MAKE_VERSION(4, 5, 0);
    out->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
    instance.knows_requirements = true;
    return XR_SUCCESS;
}

}  // namespace test_runtime
