#include <cmath>

#include "tests/openxr/action_sources.h"
#include "tests/openxr/calls.h"
#include "tests/openxr/calls/events.h"
#include "tests/openxr/calls/profiles.h"
#include "tests/openxr/world.h"

namespace test_runtime {
namespace {

constexpr const char* simple_profile = "/interaction_profiles/khr/simple_controller";

bool is_attached(const Session& session, XrActionSet set) {
    return std::find(session.attached.begin(), session.attached.end(), set) != session.attached.end();
}

void check_attached(const Session& session, XrActionSet set) {
    require(is_attached(session, set), XR_ERROR_ACTIONSET_NOT_ATTACHED,
            "the action set is not attached to the session");
}

/// The controllers' own profile if the program supports it, otherwise the simple profile, which works with
/// all controllers.
std::optional<std::string> profile_in_use(const Instance& instance) {
    const std::optional<std::string>& own = world().profile;
    if (!own || instance.suggested.contains(*own)) return own;
    return instance.suggested.contains(simple_profile) ? std::optional<std::string>(simple_profile)
                                                       : std::nullopt;
}

void update_profile(XrSession handle, Session& session) {
    Instance& instance = instance_of(session.instance);
    const std::optional<std::string> profile = profile_in_use(instance);
    if (profile == session.profile) return;
    session.profile = profile;
    note("interaction profile " + profile.value_or("none"));
    send(instance, XrEventDataInteractionProfileChanged{XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED,
                                                        nullptr, handle});
}

/// Whether the action set is active for the hand of this path.
bool is_active(const Session& session, XrActionSet set, const std::string& source) {
    const Instance& instance = instance_of(session.instance);
    return std::any_of(session.active.begin(), session.active.end(), [&](const auto& active) {
        return active.first == set && (active.second == XR_NULL_PATH ||
                                       hand_of(path_text(instance, active.second)) == hand_of(source));
    });
}

/// Whether an active action set with a higher priority uses this path.
bool is_taken(const Session& session, const std::string& source, uint32_t priority) {
    const Instance& instance = instance_of(session.instance);
    const auto& bindings = instance.suggested.at(*session.profile);
    return std::any_of(bindings.begin(), bindings.end(), [&](const SuggestedBinding& binding) {
        const Action* const action = handles().actions.find(binding.action);
        return action && binding.path == source && is_active(session, action->set, source) &&
               action_set_of(action->set).priority > priority;
    });
}

std::optional<Input> stated_input(const Hand& hand, const std::string& component) {
    const auto found = hand.inputs.find(component);
    return found == hand.inputs.end() ? std::nullopt : std::optional(found->second);
}

/// A component's value in the scenario. If it is missing, uses the stick of which the component is a
/// coordinate, or else the component's "/value" or "/click".
Input input_of(const Hand& hand, const std::string& component) {
    if (const auto stated = stated_input(hand, component)) return *stated;
    const std::string parent = component.substr(0, component.rfind('/'));
    if (const auto stated = stated_input(hand, parent)) {
        if (component.ends_with("/x")) return {stated->x, 0};
        if (component.ends_with("/y")) return {stated->y, 0};
    }
    if (const auto value = stated_input(hand, component + "/value")) return *value;
    return stated_input(hand, component + "/click").value_or(Input{});
}

float length(const Input& input) { return std::hypot(input.x, input.y); }

/// The state of an action for one hand or both, taken from the action's strongest input.
ActionState current_state(const Session& session, XrAction handle, const Action& action, XrPath subaction) {
    ActionState out;
    const uint32_t priority = action_set_of(action.set).priority;
    for (const std::string& source : sources_of(session, handle, subaction)) {
        const Hand& hand = world().now.hands[hand_of(source)];
        if (!hand.active || !is_active(session, action.set, source) || is_taken(session, source, priority))
            continue;
        const Input value = input_of(hand, component_of(source));
        if (!out.active || length(value) > length(out.value)) {
            out.value = value;
            out.source = source;
        }
        out.active = true;
    }
    return out;
}

void update(ActionState& state, ActionState now, XrActionType type) {
    const auto differs = [&] {
        if (type == XR_ACTION_TYPE_BOOLEAN_INPUT) return (state.value.x >= .5f) != (now.value.x >= .5f);
        return state.value.x != now.value.x || state.value.y != now.value.y;
    };
    now.changed = state.active && now.active && differs();
    now.changed_at = now.changed || (now.active && !state.active) ? world().display_time : state.changed_at;
    state = std::move(now);
}

void update_actions(const Session& session) {
    for (auto& [handle, action] : handles().actions) {
        if (!is_attached(session, action.set)) continue;
        std::vector<XrPath> subactions = action.subactions;
        subactions.push_back(XR_NULL_PATH);
        for (const XrPath subaction : subactions)
            update(action.states[subaction], current_state(session, handle, action, subaction), action.type);
    }
}

void check_active_set(const Session& session, const XrActiveActionSet& active) {
    action_set_of(active.actionSet);
    check_attached(session, active.actionSet);
    if (active.subactionPath == XR_NULL_PATH) return;
    path_text(instance_of(session.instance), active.subactionPath);
    const bool used = std::any_of(handles().actions.begin(), handles().actions.end(), [&](const auto& row) {
        const Action& action = row.second;
        return action.set == active.actionSet &&
               std::count(action.subactions.begin(), action.subactions.end(), active.subactionPath) > 0;
    });
    require(used, XR_ERROR_PATH_UNSUPPORTED, "no action of the set has the subaction path");
}

const ActionState& state_of(XrSession handle, const XrActionStateGetInfo* info, XrActionType type) {
    const Session& session = session_of(handle);
    check_struct(info, XR_TYPE_ACTION_STATE_GET_INFO);
    Action& action = action_of(info->action);
    require(action.type == type, XR_ERROR_ACTION_TYPE_MISMATCH, "the action has another type");
    check_attached(session, action.set);
    check_subaction(action, info->subactionPath);
    return action.states[info->subactionPath];
}

/// Sets the common members of the state structures of all action types.
template <class State>
XrResult set_state_of(State* out, const ActionState& state) {
    out->changedSinceLastSync = state.changed;
    out->lastChangeTime = state.changed_at;
    out->isActive = state.active;
    return XR_SUCCESS;
}

const Action& haptic_action(const Session& session, const XrHapticActionInfo* info) {
    check_struct(info, XR_TYPE_HAPTIC_ACTION_INFO);
    const Action& action = action_of(info->action);
    require(action.type == XR_ACTION_TYPE_VIBRATION_OUTPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
            "the action is not a vibration output");
    check_attached(session, action.set);
    check_subaction(action, info->subactionPath);
    return action;
}

bool is_user(const std::string& path) {
    return path == "/user/hand/left" || path == "/user/hand/right" || path == "/user/head" ||
           path == "/user/gamepad" || path == "/user/treadmill";
}

}  // namespace

void check_subaction(const Action& action, XrPath path) {
    if (path == XR_NULL_PATH) return;
    path_text(instance_of(action_set_of(action.set).instance), path);
    require(std::count(action.subactions.begin(), action.subactions.end(), path) > 0,
            XR_ERROR_PATH_UNSUPPORTED, "the action does not have the subaction path");
}

std::vector<std::string> sources_of(const Session& session, XrAction handle, XrPath subaction) {
    if (!session.profile) return {};
    const Instance& instance = instance_of(session.instance);
    std::vector<std::string> out;
    for (const auto& [action, path] : instance.suggested.at(*session.profile))
        if (action == handle &&
            (subaction == XR_NULL_PATH || hand_of(path_text(instance, subaction)) == hand_of(path)))
            out.push_back(path);
    return out;
}

std::optional<XrPosef> action_pose(XrSession handle, const ActionSpace& space, const Moment& moment) {
    Action* const action = handles().actions.find(space.action);
    if (!action || session_of(handle).state != XR_SESSION_STATE_FOCUSED || moment.untracked) return {};
    const ActionState& state = action->states[space.subaction];
    if (!state.active) return {};
    const Hand& hand = moment.hands[hand_of(state.source)];
    if (!hand.active) return {};
    return component_of(state.source).starts_with("/input/aim") ? hand.aim : hand.grip;
}

XrResult sync_actions(XrSession handle, const XrActionsSyncInfo* info) {
    Session& session = session_of(handle);
    check_struct(info, XR_TYPE_ACTIONS_SYNC_INFO);
    require(info->countActiveActionSets == 0 || info->activeActionSets, XR_ERROR_VALIDATION_FAILURE,
            "the action sets are missing");
    session.active.clear();
    for (uint32_t i = 0; i < info->countActiveActionSets; ++i) {
        const XrActiveActionSet& active = info->activeActionSets[i];
        check_active_set(session, active);
        session.active.emplace(active.actionSet, active.subactionPath);
    }
    const bool focused = session.state == XR_SESSION_STATE_FOCUSED;
    if (focused)
        update_profile(handle, session);
    else
        session.active.clear();
    update_actions(session);
    return focused ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

XrResult get_current_profile(XrSession handle, XrPath user, XrInteractionProfileState* out) {
    const Session& session = session_of(handle);
    Instance& instance = instance_of(session.instance);
    check_struct(out, XR_TYPE_INTERACTION_PROFILE_STATE);
    require(!session.attached.empty(), XR_ERROR_ACTIONSET_NOT_ATTACHED, "no action sets are attached");
    const std::string text = path_text(instance, user);
    require(is_user(text), XR_ERROR_PATH_UNSUPPORTED, "the path is not a top-level user path");
    const bool is_hand = hand_of(text) < world().now.hands.size();
    out->interactionProfile = is_hand && session.profile ? path_of(instance, *session.profile) : XR_NULL_PATH;
    return XR_SUCCESS;
}

XrResult get_boolean(XrSession handle, const XrActionStateGetInfo* info, XrActionStateBoolean* out) {
    const ActionState& state = state_of(handle, info, XR_ACTION_TYPE_BOOLEAN_INPUT);
    check_struct(out, XR_TYPE_ACTION_STATE_BOOLEAN);
    out->currentState = state.value.x >= .5f;
    return set_state_of(out, state);
}

XrResult get_float(XrSession handle, const XrActionStateGetInfo* info, XrActionStateFloat* out) {
    const ActionState& state = state_of(handle, info, XR_ACTION_TYPE_FLOAT_INPUT);
    check_struct(out, XR_TYPE_ACTION_STATE_FLOAT);
    out->currentState = state.value.x;
    return set_state_of(out, state);
}

XrResult get_vector(XrSession handle, const XrActionStateGetInfo* info, XrActionStateVector2f* out) {
    const ActionState& state = state_of(handle, info, XR_ACTION_TYPE_VECTOR2F_INPUT);
    check_struct(out, XR_TYPE_ACTION_STATE_VECTOR2F);
    out->currentState = state.value;
    return set_state_of(out, state);
}

XrResult get_pose(XrSession handle, const XrActionStateGetInfo* info, XrActionStatePose* out) {
    const ActionState& state = state_of(handle, info, XR_ACTION_TYPE_POSE_INPUT);
    check_struct(out, XR_TYPE_ACTION_STATE_POSE);
    out->isActive = state.active;
    return XR_SUCCESS;
}

XrResult enumerate_bound_sources(XrSession handle, const XrBoundSourcesForActionEnumerateInfo* info,
                                 uint32_t capacity, uint32_t* count, XrPath* out) {
    const Session& session = session_of(handle);
    check_struct(info, XR_TYPE_BOUND_SOURCES_FOR_ACTION_ENUMERATE_INFO);
    check_attached(session, action_of(info->action).set);
    std::vector<XrPath> paths;
    for (const std::string& source : sources_of(session, info->action, XR_NULL_PATH))
        paths.push_back(path_of(instance_of(session.instance), source));
    return fill(capacity, count, out, paths);
}

XrResult get_source_name(XrSession handle, const XrInputSourceLocalizedNameGetInfo* info, uint32_t capacity,
                         uint32_t* count, char* out) {
    const Session& session = session_of(handle);
    check_struct(info, XR_TYPE_INPUT_SOURCE_LOCALIZED_NAME_GET_INFO);
    require(!session.attached.empty(), XR_ERROR_ACTIONSET_NOT_ATTACHED, "no action sets are attached");
    constexpr XrInputSourceLocalizedNameFlags known = 7;
    require(info->whichComponents != 0 && (info->whichComponents & ~known) == 0, XR_ERROR_VALIDATION_FAILURE,
            "no component of the name is requested, or an unknown one is requested");
    const std::string source = path_text(instance_of(session.instance), info->sourcePath);
    const std::pair<XrInputSourceLocalizedNameFlags, std::string> parts[] = {
        {XR_INPUT_SOURCE_LOCALIZED_NAME_USER_PATH_BIT, hand_of(source) == 0 ? "Left Hand" : "Right Hand"},
        {XR_INPUT_SOURCE_LOCALIZED_NAME_INTERACTION_PROFILE_BIT, "Test Controller"},
        {XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT, component_of(source)}};
    std::string name;
    for (const auto& [bit, part] : parts)
        if (info->whichComponents & bit) name += (name.empty() ? "" : " ") + part;
    return fill(capacity, count, out, name);
}

XrResult apply_haptics(XrSession handle, const XrHapticActionInfo* info, const XrHapticBaseHeader* haptics) {
    const Session& session = session_of(handle);
    const Action& action = haptic_action(session, info);
    check_struct(haptics, XR_TYPE_HAPTIC_VIBRATION);
    const auto& vibration = *reinterpret_cast<const XrHapticVibration*>(haptics);
    require(vibration.duration == XR_MIN_HAPTIC_DURATION || vibration.duration > 0,
            XR_ERROR_VALIDATION_FAILURE, "the duration is not positive");
    require(vibration.amplitude >= 0 && vibration.amplitude <= 1 && vibration.frequency >= 0,
            XR_ERROR_VALIDATION_FAILURE, "the amplitude or the frequency is out of range");
    if (session.state != XR_SESSION_STATE_FOCUSED) return XR_SESSION_NOT_FOCUSED;
    note("vibration " + action.name);
    return XR_SUCCESS;
}

XrResult stop_haptics(XrSession handle, const XrHapticActionInfo* info) {
    const Session& session = session_of(handle);
    haptic_action(session, info);
    return session.state == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

}  // namespace test_runtime
