#include "player/headset/locomotion/tracked_hands.h"

#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "player/headset/locomotion/room_pose_of.h"
#include "player/headset/runtime/xr_result.h"

namespace vantage {
namespace {

/// Bindings of a controller; a null name means that the controller lacks that part.
struct Profile {
    const char* name;
    const char* select;
    const char* squeeze;
    std::array<const char*, 2> menu;  ///< left, right
    const char* stick;
    const char* press;  ///< for trackpads: the stick is active only while pressed
    bool buzzes;
};

constexpr Profile simple_controller{"/interaction_profiles/khr/simple_controller",
                                    "select/click",
                                    nullptr,
                                    {"menu/click", "menu/click"},
                                    nullptr,
                                    nullptr,
                                    true};
constexpr Profile controllers[] = {simple_controller,
                                   {"/interaction_profiles/oculus/touch_controller",
                                    "trigger/value",
                                    "squeeze/value",
                                    {"y/click", "b/click"},
                                    "thumbstick",
                                    nullptr,
                                    true},
                                   {"/interaction_profiles/valve/index_controller",
                                    "trigger/value",
                                    "squeeze/value",
                                    {"b/click", "b/click"},
                                    "thumbstick",
                                    nullptr,
                                    true},
                                   {"/interaction_profiles/htc/vive_controller",
                                    "trigger/value",
                                    "squeeze/click",
                                    {"menu/click", "menu/click"},
                                    "trackpad",
                                    "trackpad/click",
                                    true},
                                   {"/interaction_profiles/microsoft/motion_controller",
                                    "trigger/value",
                                    "squeeze/click",
                                    {"menu/click", "menu/click"},
                                    "thumbstick",
                                    nullptr,
                                    true}};
constexpr Profile microsoft_hands{"/interaction_profiles/microsoft/hand_interaction",
                                  "select/value",
                                  "squeeze/value",
                                  {nullptr, nullptr},
                                  nullptr,
                                  nullptr,
                                  false};
constexpr Profile bare_hands{"/interaction_profiles/ext/hand_interaction_ext",
                             "pinch_ext/value",
                             "grasp_ext/value",
                             {nullptr, nullptr},
                             nullptr,
                             nullptr,
                             false};

constexpr const char* side_names[] = {"/user/hand/left", "/user/hand/right"};

XrAction make_action(XrActionSet set, XrActionType type, const char* name, const char* shown,
                     const std::array<XrPath, 2>& sides) {
    auto info = typed<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
    std::strncpy(info.actionName, name, sizeof info.actionName - 1);
    std::strncpy(info.localizedActionName, shown, sizeof info.localizedActionName - 1);
    info.actionType = type;
    info.countSubactionPaths = std::uint32_t(sides.size());
    info.subactionPaths = sides.data();
    XrAction out = XR_NULL_HANDLE;
    expect(xrCreateAction(set, &info, &out), "xrCreateAction");
    return out;
}

XrSpace make_action_space(XrSession session, XrAction action, XrPath side) {
    auto info = typed<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
    info.action = action;
    info.subactionPath = side;
    info.poseInActionSpace.orientation.w = 1;
    XrSpace out = XR_NULL_HANDLE;
    expect(xrCreateActionSpace(session, &info, &out), "xrCreateActionSpace");
    return out;
}

XrActionStateGetInfo of_side(XrAction action, XrPath side) {
    return {XR_TYPE_ACTION_STATE_GET_INFO, nullptr, action, side};
}

/// Returns nullopt if no button of this hand is bound to the action.
std::optional<bool> pressed(XrSession session, XrAction action, XrPath side) {
    const XrActionStateGetInfo info = of_side(action, side);
    auto state = typed<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
    expect(xrGetActionStateBoolean(session, &info, &state), "xrGetActionStateBoolean");
    if (!state.isActive) return {};
    return state.currentState != XR_FALSE;
}

std::optional<Eigen::Vector2d> stick_of(XrSession session, XrAction action, XrPath side) {
    const XrActionStateGetInfo info = of_side(action, side);
    auto state = typed<XrActionStateVector2f>(XR_TYPE_ACTION_STATE_VECTOR2F);
    expect(xrGetActionStateVector2f(session, &info, &state), "xrGetActionStateVector2f");
    if (!state.isActive) return {};
    return Eigen::Vector2d(double(state.currentState.x), double(state.currentState.y));
}

std::optional<RoomPose> pose_in(XrSpace space, XrSpace room, XrTime time) {
    auto location = typed<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
    expect(xrLocateSpace(space, room, time, &location), "xrLocateSpace");
    constexpr XrSpaceLocationFlags both =
        XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    if ((location.locationFlags & both) != both) return {};
    const RoomPose pose = room_pose_of(location.pose);
    if (!is_valid(pose)) return {};
    return pose;
}

}  // namespace

TrackedHands::TrackedHands(const XrRuntime& runtime, XrSession session) : session_(session) {
    auto info = typed<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
    std::strcpy(info.actionSetName, "hands");
    std::strcpy(info.localizedActionSetName, "Hands");
    expect(xrCreateActionSet(runtime.get(), &info, &set_), "xrCreateActionSet");
    try {
        make_actions(runtime);
    } catch (...) {  // otherwise the set would outlive the session
        xrDestroyActionSet(set_);
        throw;
    }
}

void TrackedHands::make_actions(const XrRuntime& runtime) {
    for (std::size_t i = 0; i < 2; ++i) sides_[i] = runtime.path(side_names[i]);
    const auto make = [&](XrActionType type, const char* name, const char* shown) {
        return make_action(set_, type, name, shown, sides_);
    };
    aim_ = make(XR_ACTION_TYPE_POSE_INPUT, "aim", "Point");
    grip_ = make(XR_ACTION_TYPE_POSE_INPUT, "grip", "Hand");
    select_ = make(XR_ACTION_TYPE_BOOLEAN_INPUT, "select", "Select");
    squeeze_ = make(XR_ACTION_TYPE_BOOLEAN_INPUT, "squeeze", "Hold the scene");
    menu_ = make(XR_ACTION_TYPE_BOOLEAN_INPUT, "menu", "Menu");
    stick_ = make(XR_ACTION_TYPE_VECTOR2F_INPUT, "move", "Move and turn");
    press_ = make(XR_ACTION_TYPE_BOOLEAN_INPUT, "press", "Use the trackpad to move");
    buzz_ = make(XR_ACTION_TYPE_VIBRATION_OUTPUT, "buzz", "Buzz");
    suggest_all(runtime);
    XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 1, &set_};
    expect(xrAttachSessionActionSets(session_, &attach), "xrAttachSessionActionSets");
    for (std::size_t i = 0; i < 2; ++i) {
        aims_[i] = make_action_space(session_, aim_, sides_[i]);
        grips_[i] = make_action_space(session_, grip_, sides_[i]);
    }
}

TrackedHands::~TrackedHands() {
    for (const auto& spaces : {aims_, grips_})
        for (const XrSpace space : spaces)
            if (space) xrDestroySpace(space);
    if (set_) xrDestroyActionSet(set_);
}

void TrackedHands::suggest_all(const XrRuntime& runtime) const {
    bool any = false;
    const auto suggest = [&](const Profile& p) {
        std::vector<XrActionSuggestedBinding> bindings;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto bind = [&](XrAction action, const std::string& part) {
                bindings.push_back({action, runtime.path((side_names[i] + part).c_str())});
            };
            const auto input = [&](XrAction action, const char* part) {
                if (part) bind(action, "/input/" + std::string(part));
            };
            input(aim_, "aim/pose");
            input(grip_, "grip/pose");
            input(select_, p.select);
            input(squeeze_, p.squeeze);
            input(menu_, p.menu[i]);
            input(stick_, p.stick);
            input(press_, p.press);
            if (p.buzzes) bind(buzz_, "/output/haptic");
        }
        const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING,
                                                        nullptr, runtime.path(p.name),
                                                        std::uint32_t(bindings.size()), bindings.data()};
        const XrResult result = xrSuggestInteractionProfileBindings(runtime.get(), &info);
        if (result == XR_ERROR_PATH_UNSUPPORTED) return;  // other profiles may be supported
        expect(result, "xrSuggestInteractionProfileBindings");
        any = true;
    };
    for (const Profile& p : controllers) suggest(p);
    if (runtime.extensions().microsoft_hands) suggest(microsoft_hands);
    if (runtime.extensions().hands) suggest(bare_hands);
    if (!any)
        throw Error(Exit::graphics, "headset: the OpenXR runtime supports none of the known controllers");
}

std::optional<Hands> TrackedHands::at(XrTime time, XrSpace room) {
    const XrActiveActionSet active{set_, XR_NULL_PATH};
    const XrActionsSyncInfo info{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
    if (expect(xrSyncActions(session_, &info), "xrSyncActions") == XR_SESSION_NOT_FOCUSED) return {};
    return Hands{hand_at(0, time, room), hand_at(1, time, room)};
}

Hand TrackedHands::hand_at(std::size_t i, XrTime time, XrSpace room) const {
    const XrPath side = sides_[i];
    Hand hand;
    hand.aim = pose_in(aims_[i], room, time);
    hand.grip = pose_in(grips_[i], room, time);
    hand.select = pressed(session_, select_, side).value_or(false);
    hand.squeeze = pressed(session_, squeeze_, side).value_or(false);
    const auto menu = pressed(session_, menu_, side);
    hand.has_menu = menu.has_value();
    hand.menu = menu.value_or(false);
    const auto stick = stick_of(session_, stick_, side);
    hand.has_stick = stick.has_value();
    if (stick && pressed(session_, press_, side).value_or(true) && stick->allFinite()) hand.stick = *stick;
    return hand;
}

void TrackedHands::buzz(std::size_t hand) const {
    auto vibration = typed<XrHapticVibration>(XR_TYPE_HAPTIC_VIBRATION);
    vibration.duration = XR_MIN_HAPTIC_DURATION;
    vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
    vibration.amplitude = 0.5f;
    const XrHapticActionInfo info{XR_TYPE_HAPTIC_ACTION_INFO, nullptr, buzz_, sides_.at(hand)};
    xrApplyHapticFeedback(session_, &info, reinterpret_cast<const XrHapticBaseHeader*>(&vibration));
}

}  // namespace vantage
