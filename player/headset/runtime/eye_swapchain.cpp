#include "player/headset/runtime/eye_swapchain.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/text/error.h"
#include "player/headset/runtime/enumerated.h"
#include "player/headset/runtime/openxr_graphics.h"
#include "player/headset/runtime/shared_context.h"
#include "player/headset/runtime/xr_result.h"

namespace vantage {
namespace {

std::int64_t first_offered(XrSession session, std::span<const std::int64_t> wanted) {
    const auto offered =
        enumerated<std::int64_t>("xrEnumerateSwapchainFormats", 0,
                                 [&](std::uint32_t capacity, std::uint32_t* count, std::int64_t* out) {
                                     return xrEnumerateSwapchainFormats(session, capacity, count, out);
                                 });
    for (const std::int64_t format : wanted)
        if (std::ranges::count(offered, format) > 0) return format;
    return 0;
}

std::vector<XrSwapchainImageOpenGLKHR> images_of(XrSwapchain swapchain) {
    return enumerated("xrEnumerateSwapchainImages",
                      typed<XrSwapchainImageOpenGLKHR>(XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR),
                      [&](std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageOpenGLKHR* out) {
                          return xrEnumerateSwapchainImages(
                              swapchain, capacity, count, reinterpret_cast<XrSwapchainImageBaseHeader*>(out));
                      });
}

}  // namespace

EyeSwapchain::EyeSwapchain(XrSession session, FrameSize size, std::int64_t format, bool depth) : size_(size) {
    auto info = typed<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
    info.usageFlags = depth ? XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                            : XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
    info.format = format;
    info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
    info.width = std::uint32_t(size.width), info.height = std::uint32_t(size.height);
    {
        const SharedContext shared;
        expect(xrCreateSwapchain(session, &info, &swapchain_), "xrCreateSwapchain");
    }
    for (const XrSwapchainImageOpenGLKHR& image : images_of(swapchain_))
        targets_.push_back(depth ? gl::make_framebuffer("headset's depth", {}, image.image)
                                 : gl::make_framebuffer("headset", std::array{GLuint(image.image)}, 0));
}

EyeSwapchain::EyeSwapchain(EyeSwapchain&& o) noexcept
    : swapchain_(std::exchange(o.swapchain_, XR_NULL_HANDLE)),
      size_(o.size_),
      acquired_(o.acquired_),
      taken_(o.taken_),
      targets_(std::move(o.targets_)) {}

EyeSwapchain::~EyeSwapchain() {
    targets_.clear();  // before the images that they reference
    if (swapchain_) xrDestroySwapchain(swapchain_);
}

void EyeSwapchain::acquire() {
    const SharedContext shared;
    const XrSwapchainImageAcquireInfo acquire{XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO, nullptr};
    expect(xrAcquireSwapchainImage(swapchain_, &acquire, &taken_), "xrAcquireSwapchainImage");
    acquired_ = true;
    const XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, nullptr, XR_INFINITE_DURATION};
    expect(xrWaitSwapchainImage(swapchain_, &wait), "xrWaitSwapchainImage");
}

void EyeSwapchain::release() {
    if (!std::exchange(acquired_, false)) return;
    const SharedContext shared;
    const XrSwapchainImageReleaseInfo info{XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO, nullptr};
    expect(xrReleaseSwapchainImage(swapchain_, &info), "xrReleaseSwapchainImage");
}

std::int64_t color_format(XrSession session) {
    const std::int64_t out = first_offered(session, std::array<std::int64_t, 2>{GL_SRGB8_ALPHA8, GL_SRGB8});
    if (out == 0) throw Error(Exit::graphics, "headset: the OpenXR runtime offers no sRGB pictures");
    return out;
}

std::int64_t depth_format(XrSession session) {
    return first_offered(session, std::array<std::int64_t, 2>{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT24});
}

}  // namespace vantage
