#include "tests/openxr/calls.h"
#include "tests/openxr/calls/handles.h"
#include "tests/openxr/calls/system.h"
#include "tests/openxr/graphics.h"
#include "tests/openxr/openxr_gl.h"
#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

constexpr std::size_t images = 3;

void check_size(const XrSwapchainCreateInfo& info) {
    require(info.width > 0 && info.height > 0 && info.width <= max_swapchain_side &&
                info.height <= max_swapchain_side,
            XR_ERROR_VALIDATION_FAILURE, "the width or the height is 0 or exceeds the maximum");
    require(info.arraySize > 0 && info.mipCount > 0 && info.sampleCount > 0, XR_ERROR_VALIDATION_FAILURE,
            "the array size, the mip count or the sample count is 0");
    require(info.faceCount == 1 || info.faceCount == 6, XR_ERROR_VALIDATION_FAILURE,
            "the number of faces is neither 1 nor 6");
    require(info.faceCount == 1 && info.sampleCount == 1, XR_ERROR_FEATURE_UNSUPPORTED,
            "cubes and multisampling are not supported");
}

void check_use(const XrSwapchainCreateInfo& info) {
    const std::vector<int64_t>& formats = world().scenario.formats;
    require(std::find(formats.begin(), formats.end(), info.format) != formats.end(),
            XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "the format is not among those of the session");
    require((info.createFlags & ~XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT) == 0, XR_ERROR_FEATURE_UNSUPPORTED,
            "a flag is not supported");
    constexpr XrSwapchainUsageFlags known = 0x7f;  // all flags of the core specification
    require((info.usageFlags & ~known) == 0, XR_ERROR_FEATURE_UNSUPPORTED, "a usage is not supported");
    const XrSwapchainUsageFlags other = is_depth(info.format)
                                            ? XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT
                                            : XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    require((info.usageFlags & other) == 0, XR_ERROR_VALIDATION_FAILURE,
            "the usage does not match the format");
}

bool is_static(const Swapchain& swapchain) {
    return swapchain.info.createFlags & XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT;
}

}  // namespace

XrResult enumerate_swapchain_formats(XrSession handle, uint32_t capacity, uint32_t* count, int64_t* out) {
    session_of(handle);
    return fill(capacity, count, out, world().scenario.formats);
}

XrResult create_swapchain(XrSession handle, const XrSwapchainCreateInfo* info, XrSwapchain* out) {
    const Session& session = session_of(handle);
    check_struct(info, XR_TYPE_SWAPCHAIN_CREATE_INFO);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the swapchain is null");
    check_size(*info);
    check_use(*info);
    if (!check_graphics(session)) return XR_ERROR_RUNTIME_FAILURE;
    Swapchain swapchain{};
    swapchain.session = handle;
    swapchain.info = *info;
    swapchain.info.next = nullptr;
    swapchain.textures = make_textures(*info, is_static(swapchain) ? 1 : images);
    *out = handles().swapchains.add(std::move(swapchain));
    be_careless();
    return XR_SUCCESS;
}

XrResult destroy_swapchain(XrSwapchain handle) {
    const Swapchain& swapchain = live(handles().swapchains, handle);
    if (check_graphics(live(handles().sessions, swapchain.session))) delete_textures(swapchain.textures);
    handles().swapchains.erase(handle);
    return XR_SUCCESS;
}

XrResult enumerate_swapchain_images(XrSwapchain handle, uint32_t capacity, uint32_t* count,
                                    XrSwapchainImageBaseHeader* out) {
    const std::vector<uint32_t>& textures = swapchain_of(handle).textures;
    return fill_structs(capacity, count, reinterpret_cast<XrSwapchainImageOpenGLKHR*>(out), textures.size(),
                        XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR,
                        [&](XrSwapchainImageOpenGLKHR& image, std::size_t i) { image.image = textures[i]; });
}

XrResult acquire_image(XrSwapchain handle, const XrSwapchainImageAcquireInfo* info, uint32_t* index) {
    Swapchain& swapchain = swapchain_of(handle);
    if (info) check_struct(info, XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO);
    require(index, XR_ERROR_VALIDATION_FAILURE, "the output for the index is null");
    require(swapchain.acquired.size() < swapchain.textures.size(), XR_ERROR_CALL_ORDER_INVALID,
            "all images are acquired");
    require(!is_static(swapchain) || !swapchain.released, XR_ERROR_CALL_ORDER_INVALID,
            "a static image can be acquired only once");
    *index = swapchain.next;
    swapchain.next = (swapchain.next + 1) % uint32_t(swapchain.textures.size());
    swapchain.acquired.push_back(*index);
    be_careless();
    return XR_SUCCESS;
}

XrResult wait_image(XrSwapchain handle, const XrSwapchainImageWaitInfo* info) {
    Swapchain& swapchain = swapchain_of(handle);
    check_struct(info, XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    require(info->timeout >= 0, XR_ERROR_VALIDATION_FAILURE, "the timeout is negative");
    require(!swapchain.waited, XR_ERROR_CALL_ORDER_INVALID, "the previous image is not released");
    require(!swapchain.acquired.empty(), XR_ERROR_CALL_ORDER_INVALID, "no image is acquired");
    swapchain.waited = true;
    return XR_SUCCESS;
}

XrResult release_image(XrSwapchain handle, const XrSwapchainImageReleaseInfo* info) {
    Swapchain& swapchain = swapchain_of(handle);
    if (info) check_struct(info, XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO);
    require(swapchain.waited, XR_ERROR_CALL_ORDER_INVALID, "no image has been waited for");
    swapchain.released = swapchain.acquired.front();
    swapchain.acquired.pop_front();
    swapchain.waited = false;
    return XR_SUCCESS;
}

}  // namespace test_runtime
