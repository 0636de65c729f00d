#include "player/headset/runtime/xr_runtime.h"

#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/text/error.h"
#include "player/headset/runtime/openxr_graphics.h"
#include "player/headset/runtime/xr_result.h"

namespace vantage {
namespace {

constexpr char hands_extension[] = "XR_EXT_hand_interaction";  // newer than some packages of the header

/// Suppresses the loader's own messages, which would precede the player's. To see them when debugging, set
/// XR_LOADER_DEBUG.
void quiet_loader() { ::setenv("XR_LOADER_DEBUG", "none", 0); }

[[noreturn]] void fail(const std::string& why) { throw Error(Exit::graphics, "headset: " + why); }

[[noreturn]] void fail_to_connect(XrResult result) {
    switch (result) {
        case XR_ERROR_RUNTIME_UNAVAILABLE:
        case XR_ERROR_INSTANCE_LOST:
        case XR_ERROR_FILE_ACCESS_ERROR:
        case XR_ERROR_FILE_CONTENTS_INVALID:
            fail(
                "no OpenXR runtime responds; start Monado, SteamVR or another runtime and make it the active "
                "one (~/.config/openxr/1/active_runtime.json, or the variable XR_RUNTIME_JSON)");
        case XR_ERROR_API_VERSION_UNSUPPORTED:
            fail("the OpenXR runtime does not support version 1.0");
        default:
            fail(std::string("the OpenXR runtime reports ") + name_of(result));
    }
}

std::vector<XrExtensionProperties> offered_extensions() {
    std::uint32_t count = 0;
    XrResult result = xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr);
    std::vector<XrExtensionProperties> out(count, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
    if (XR_SUCCEEDED(result) && count > 0)
        result = xrEnumerateInstanceExtensionProperties(nullptr, count, &count, out.data());
    if (XR_FAILED(result)) fail_to_connect(result);
    out.resize(count);
    return out;
}

template <std::size_t N>
void set_text(char (&to)[N], std::string_view text) {
    std::memcpy(to, text.data(), std::min(text.size(), N - 1));
}

}  // namespace

bool runtime_answers() {
    quiet_loader();
    std::uint32_t count = 0;
    return XR_SUCCEEDED(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr));
}

XrRuntime::XrRuntime() {
    quiet_loader();
    const std::vector<XrExtensionProperties> offered = offered_extensions();
    std::vector<const char*> wanted;
    const auto use = [&](const char* name) {
        for (const XrExtensionProperties& e : offered)
            if (std::strcmp(e.extensionName, name) == 0) {
                wanted.push_back(name);
                return true;
            }
        return false;
    };
    if (!use(XR_KHR_OPENGL_ENABLE_EXTENSION_NAME))
        fail("the OpenXR runtime does not support OpenGL (XR_KHR_opengl_enable)");
    extensions_.egl = use(XR_MNDX_EGL_ENABLE_EXTENSION_NAME);
    extensions_.depth = use(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME);
    extensions_.microsoft_hands = use(XR_MSFT_HAND_INTERACTION_EXTENSION_NAME);
    extensions_.hands = use(hands_extension);
    auto info = typed<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
    set_text(info.applicationInfo.applicationName, "vantage-player");
    set_text(info.applicationInfo.engineName, "Vantage");
    info.applicationInfo.applicationVersion = info.applicationInfo.engineVersion = 1;
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    info.enabledExtensionCount = std::uint32_t(wanted.size());
    info.enabledExtensionNames = wanted.data();
    if (const XrResult result = xrCreateInstance(&info, &instance_); XR_FAILED(result))
        fail_to_connect(result);
    auto properties = typed<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
    expect(xrGetInstanceProperties(instance_, &properties), "xrGetInstanceProperties");
    const XrVersion v = properties.runtimeVersion;
    name_ = std::string(properties.runtimeName) + " " + std::to_string(XR_VERSION_MAJOR(v)) + "." +
            std::to_string(XR_VERSION_MINOR(v)) + "." + std::to_string(XR_VERSION_PATCH(v));
}

XrRuntime::~XrRuntime() {
    if (instance_) xrDestroyInstance(instance_);
}

XrPath XrRuntime::path(const char* text) const {
    XrPath out = XR_NULL_PATH;
    expect(xrStringToPath(instance_, text, &out), "xrStringToPath");
    return out;
}

XrSystemId headset_of(const XrRuntime& runtime) {
    auto info = typed<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
    info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    XrSystemId out = XR_NULL_SYSTEM_ID;
    const XrResult result = xrGetSystem(runtime.get(), &info, &out);
    if (result == XR_ERROR_FORM_FACTOR_UNAVAILABLE || result == XR_ERROR_FORM_FACTOR_UNSUPPORTED)
        fail(runtime.name() + " finds no headset; is one connected and switched on?");
    expect(result, "xrGetSystem");
    return out;
}

}  // namespace vantage
