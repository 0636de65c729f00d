#include <array>

#include "tests/openxr/calls.h"
#include "tests/openxr/calls/handles.h"
#include "tests/openxr/calls/profiles.h"

namespace test_runtime {
namespace {

void check_name(const std::string& name) {
    const bool fits = std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    });
    if (!fits)
        breach(XR_ERROR_PATH_FORMAT_INVALID,
               "the name \"" + name + "\" contains characters that are not allowed in names");
}

/// Checks that the names of an action or an action set differ from those of all others.
template <class Named>
void check_difference(const Named& added, const Named& other) {
    if (added.name == other.name) breach(XR_ERROR_NAME_DUPLICATED, "there is \"" + added.name + "\" already");
    if (added.localized_name == other.localized_name)
        breach(XR_ERROR_LOCALIZED_NAME_DUPLICATED, "there is \"" + added.localized_name + "\" already");
}

void check_subactions(const Instance& instance, const std::vector<XrPath>& paths) {
    constexpr std::array known = {"/user/hand/left", "/user/hand/right", "/user/head", "/user/gamepad",
                                  "/user/treadmill"};
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const std::string& text = path_text(instance, paths[i]);
        if (std::find(known.begin(), known.end(), text) == known.end())
            breach(XR_ERROR_PATH_UNSUPPORTED, text + " is not a top-level user path");
        if (std::find(paths.begin(), paths.begin() + std::ptrdiff_t(i), paths[i]) !=
            paths.begin() + std::ptrdiff_t(i))
            breach(XR_ERROR_PATH_UNSUPPORTED, text + " is given twice");
    }
}

void check_profile(const Instance& instance, const std::string& profile) {
    if (!is_known_profile(profile))
        breach(XR_ERROR_PATH_UNSUPPORTED, profile + " is not a known interaction profile");
    const std::string extension = extension_of_profile(profile);
    if (!extension.empty() && !instance.extensions.contains(extension))
        breach(XR_ERROR_PATH_UNSUPPORTED, profile + " needs " + extension);
}

SuggestedBinding checked_binding(XrInstance handle, const std::string& profile,
                                 const XrActionSuggestedBinding& binding) {
    const Action& action = action_of(binding.action);
    const ActionSet& set = action_set_of(action.set);
    require(set.instance == handle, XR_ERROR_HANDLE_INVALID, "the action belongs to another instance");
    require(!set.attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "the action's set is already attached");
    const std::string& path = path_text(instance_of(handle), binding.binding);
    if (!has_component(profile, path)) breach(XR_ERROR_PATH_UNSUPPORTED, profile + " has no " + path);
    if (!suits_action(profile, path, action.type))
        breach(XR_ERROR_PATH_UNSUPPORTED, path + " does not match the type of the action " + action.name);
    return {binding.action, path};
}

}  // namespace

XrResult create_action_set(XrInstance handle, const XrActionSetCreateInfo* info, XrActionSet* out) {
    instance_of(handle);
    check_struct(info, XR_TYPE_ACTION_SET_CREATE_INFO);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the action set is null");
    const ActionSet set{
        handle,
        checked_text(info->actionSetName, XR_MAX_ACTION_SET_NAME_SIZE, XR_ERROR_NAME_INVALID, "the name"),
        checked_text(info->localizedActionSetName, XR_MAX_LOCALIZED_ACTION_SET_NAME_SIZE,
                     XR_ERROR_LOCALIZED_NAME_INVALID, "the localized name"),
        info->priority};
    check_name(set.name);
    for (const auto& [other_handle, other] : handles().action_sets)
        if (other.instance == handle) check_difference(set, other);
    *out = handles().action_sets.add(set);
    return XR_SUCCESS;
}

XrResult destroy_action_set(XrActionSet handle) {
    live(handles().action_sets, handle);
    handles().actions.erase_if([&](const Action& action) { return action.set == handle; });
    handles().action_sets.erase(handle);
    return XR_SUCCESS;
}

XrResult create_action(XrActionSet handle, const XrActionCreateInfo* info, XrAction* out) {
    const ActionSet& set = action_set_of(handle);
    check_struct(info, XR_TYPE_ACTION_CREATE_INFO);
    require(out, XR_ERROR_VALIDATION_FAILURE, "the output for the action is null");
    require(!set.attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "the action set is already attached");
    Action action{handle,
                  checked_text(info->actionName, XR_MAX_ACTION_NAME_SIZE, XR_ERROR_NAME_INVALID, "the name"),
                  checked_text(info->localizedActionName, XR_MAX_LOCALIZED_ACTION_NAME_SIZE,
                               XR_ERROR_LOCALIZED_NAME_INVALID, "the localized name"),
                  info->actionType,
                  {},
                  {}};
    check_name(action.name);
    constexpr std::array types = {XR_ACTION_TYPE_BOOLEAN_INPUT, XR_ACTION_TYPE_FLOAT_INPUT,
                                  XR_ACTION_TYPE_VECTOR2F_INPUT, XR_ACTION_TYPE_POSE_INPUT,
                                  XR_ACTION_TYPE_VIBRATION_OUTPUT};
    require(std::find(types.begin(), types.end(), action.type) != types.end(), XR_ERROR_VALIDATION_FAILURE,
            "the action type is unknown");
    require(info->countSubactionPaths == 0 || info->subactionPaths, XR_ERROR_VALIDATION_FAILURE,
            "the subaction paths are missing");
    if (info->countSubactionPaths > 0)
        action.subactions.assign(info->subactionPaths, info->subactionPaths + info->countSubactionPaths);
    check_subactions(instance_of(set.instance), action.subactions);
    for (const auto& [other_handle, other] : handles().actions)
        if (other.set == handle) check_difference(action, other);
    *out = handles().actions.add(std::move(action));
    return XR_SUCCESS;
}

XrResult destroy_action(XrAction handle) {
    live(handles().actions, handle);
    handles().actions.erase(handle);
    return XR_SUCCESS;
}

XrResult suggest_bindings(XrInstance handle, const XrInteractionProfileSuggestedBinding* info) {
    Instance& instance = instance_of(handle);
    check_struct(info, XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    const std::string profile = path_text(instance, info->interactionProfile);
    check_profile(instance, profile);
    require(info->countSuggestedBindings > 0 && info->suggestedBindings, XR_ERROR_VALIDATION_FAILURE,
            "there are no bindings");
    std::vector<SuggestedBinding> bindings;
    for (uint32_t i = 0; i < info->countSuggestedBindings; ++i)
        bindings.push_back(checked_binding(handle, profile, info->suggestedBindings[i]));
    instance.suggested[profile] = std::move(bindings);
    return XR_SUCCESS;
}

XrResult attach_action_sets(XrSession handle, const XrSessionActionSetsAttachInfo* info) {
    Session& session = session_of(handle);
    check_struct(info, XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
    require(info->countActionSets > 0 && info->actionSets, XR_ERROR_VALIDATION_FAILURE,
            "there are no action sets");
    require(session.attached.empty(), XR_ERROR_ACTIONSETS_ALREADY_ATTACHED,
            "action sets are already attached to the session");
    const std::vector<XrActionSet> sets(info->actionSets, info->actionSets + info->countActionSets);
    for (const XrActionSet set : sets)
        require(action_set_of(set).instance == session.instance, XR_ERROR_HANDLE_INVALID,
                "an action set belongs to another instance");
    for (const XrActionSet set : sets) action_set_of(set).attached = true;
    for (auto& [action_handle, action] : handles().actions) action.states.clear();
    session.attached = sets;
    return XR_SUCCESS;
}

}  // namespace test_runtime
