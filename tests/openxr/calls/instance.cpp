#include <openxr/openxr_reflection.h>

#include <cstring>

#include "tests/openxr/calls.h"
#include "tests/openxr/calls/checks.h"
#include "tests/openxr/calls/events.h"
#include "tests/openxr/calls/handles.h"
#include "tests/openxr/calls/session.h"
#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

constexpr const char* layer_error = "an API layer is requested from the runtime";

template <std::size_t n>
void set_text(char (&out)[n], const std::string& text) {
    out[text.copy(out, n - 1)] = '\0';
}

void check_application(const XrApplicationInfo& info) {
    checked_text(info.applicationName, XR_MAX_APPLICATION_NAME_SIZE, XR_ERROR_NAME_INVALID,
                 "the application's name");
    require(std::memchr(info.engineName, '\0', XR_MAX_ENGINE_NAME_SIZE), XR_ERROR_VALIDATION_FAILURE,
            "the engine's name is not terminated");
    require(XR_VERSION_MAJOR(info.apiVersion) == 1 && XR_VERSION_MINOR(info.apiVersion) == 0,
            XR_ERROR_API_VERSION_UNSUPPORTED, "only OpenXR 1.0 is supported");
}

std::set<std::string> checked_extensions(const XrInstanceCreateInfo& info) {
    std::set<std::string> out;
    const std::vector<std::string>& offered = world().scenario.extensions;
    for (uint32_t i = 0; i < info.enabledExtensionCount; ++i) {
        const std::string name = info.enabledExtensionNames[i];
        if (std::find(offered.begin(), offered.end(), name) == offered.end())
            breach(XR_ERROR_EXTENSION_NOT_PRESENT, name + " is not offered");
        if (!out.insert(name).second) breach(XR_ERROR_VALIDATION_FAILURE, name + " is enabled twice");
    }
    return out;
}

bool is_path_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '/';
}

/// Whether a path consists of levels with lowercase names, none of which contains only dots.
bool is_well_formed(const std::string& path) {
    if (path.size() < 2 || path.size() >= XR_MAX_PATH_LENGTH || path[0] != '/' || path.back() == '/')
        return false;
    if (!std::all_of(path.begin(), path.end(), is_path_character)) return false;
    for (std::size_t from = 1; from < path.size();) {
        const std::size_t to = std::min(path.find('/', from), path.size());
        if (path.find_first_not_of('.', from) >= to) return false;
        from = to + 1;
    }
    return true;
}

}  // namespace

XrResult enumerate_instance_extensions(const char* layer, uint32_t capacity, uint32_t* count,
                                       XrExtensionProperties* out) {
    require(!layer, XR_ERROR_API_LAYER_NOT_PRESENT, layer_error);
    const std::vector<std::string>& offered = world().scenario.extensions;
    return fill_structs(capacity, count, out, offered.size(), XR_TYPE_EXTENSION_PROPERTIES,
                        [&](XrExtensionProperties& extension, std::size_t i) {
                            set_text(extension.extensionName, offered[i]);
                            extension.extensionVersion = 1;
                        });
}

XrResult create_instance(const XrInstanceCreateInfo* info, XrInstance* out) {
    check_struct(info, XR_TYPE_INSTANCE_CREATE_INFO);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the instance is null");
    require(info->createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "the flags are not 0");
    check_application(info->applicationInfo);
    require(info->enabledApiLayerCount == 0, XR_ERROR_API_LAYER_NOT_PRESENT, layer_error);
    Instance instance{};
    instance.extensions = checked_extensions(*info);
    require(handles().instances.empty(), XR_ERROR_LIMIT_REACHED, "an instance already exists");
    if (handles().unavailable > 0) {
        --handles().unavailable;
        return XR_ERROR_RUNTIME_UNAVAILABLE;
    }
    static uint64_t made = 0;
    instance.first_path = ++made << 32;
    *out = handles().instances.add(std::move(instance));
    note("instance created");
    return XR_SUCCESS;
}

XrResult destroy_instance(XrInstance handle) {
    live(handles().instances, handle);
    for (const XrSession session : sessions_of(handle)) end_all_of(session);
    handles().actions.erase_if([&](const Action& action) {
        const ActionSet* const set = handles().action_sets.find(action.set);
        return !set || set->instance == handle;
    });
    handles().action_sets.erase_if([&](const ActionSet& set) { return set.instance == handle; });
    handles().instances.erase(handle);
    note("instance destroyed");
    return XR_SUCCESS;
}

XrResult get_instance_properties(XrInstance handle, XrInstanceProperties* out) {
    instance_of(handle);
    check_struct(out, XR_TYPE_INSTANCE_PROPERTIES);
    out->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
    set_text(out->runtimeName, "Test runtime");
    return XR_SUCCESS;
}

XrResult result_to_string(XrInstance handle, XrResult result, char* out) {
    live(handles().instances, handle);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the text is null");
    out[result_name(result).copy(out, XR_MAX_RESULT_STRING_SIZE - 1)] = '\0';
    return XR_SUCCESS;
}

XrResult structure_type_to_string(XrInstance handle, XrStructureType type, char* out) {
    live(handles().instances, handle);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the text is null");
    out[type_name(type).copy(out, XR_MAX_STRUCTURE_NAME_SIZE - 1)] = '\0';
    return XR_SUCCESS;
}

XrResult string_to_path(XrInstance handle, const char* text, XrPath* out) {
    Instance& instance = instance_of(handle);
    require(text && out, XR_ERROR_VALIDATION_FAILURE, "the text or the output for the path is null");
    if (!is_well_formed(text))
        breach(XR_ERROR_PATH_FORMAT_INVALID, "\"" + std::string(text) + "\" is not a well-formed path");
    *out = path_of(instance, text);
    return XR_SUCCESS;
}

XrResult path_to_string(XrInstance handle, XrPath path, uint32_t capacity, uint32_t* count, char* out) {
    return fill(capacity, count, out, path_text(instance_of(handle), path));
}

}  // namespace test_runtime
