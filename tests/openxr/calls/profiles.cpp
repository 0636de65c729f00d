#include "tests/openxr/calls/profiles.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace test_runtime {
namespace {

enum class Kind { boolean, number, vector, pose, haptic };
enum class Side { left, right, both };

struct Component {
    const char* path;
    Kind kind;
    Side side = Side::both;
};

struct Profile {
    const char* name;
    const char* extension;
    std::vector<Component> components;
};

constexpr Component grip = {"/input/grip/pose", Kind::pose}, aim = {"/input/aim/pose", Kind::pose},
                    vibration = {"/output/haptic", Kind::haptic},
                    trigger = {"/input/trigger/value", Kind::number},
                    trigger_click = {"/input/trigger/click", Kind::boolean},
                    trigger_touch = {"/input/trigger/touch", Kind::boolean},
                    squeeze = {"/input/squeeze/value", Kind::number},
                    squeeze_click = {"/input/squeeze/click", Kind::boolean},
                    menu = {"/input/menu/click", Kind::boolean},
                    system = {"/input/system/click", Kind::boolean},
                    stick = {"/input/thumbstick", Kind::vector},
                    stick_x = {"/input/thumbstick/x", Kind::number},
                    stick_y = {"/input/thumbstick/y", Kind::number},
                    stick_click = {"/input/thumbstick/click", Kind::boolean},
                    stick_touch = {"/input/thumbstick/touch", Kind::boolean},
                    pad = {"/input/trackpad", Kind::vector}, pad_x = {"/input/trackpad/x", Kind::number},
                    pad_y = {"/input/trackpad/y", Kind::number},
                    pad_click = {"/input/trackpad/click", Kind::boolean},
                    pad_touch = {"/input/trackpad/touch", Kind::boolean};

const std::vector<Profile>& profiles() {
    static const std::vector<Profile> all = {
        {"/interaction_profiles/khr/simple_controller",
         "",
         {{"/input/select/click", Kind::boolean}, menu, grip, aim, vibration}},
        {"/interaction_profiles/google/daydream_controller",
         "",
         {{"/input/select/click", Kind::boolean}, pad, pad_x, pad_y, pad_click, pad_touch, grip, aim}},
        {"/interaction_profiles/oculus/go_controller",
         "",
         {system,
          trigger_click,
          {"/input/back/click", Kind::boolean},
          pad,
          pad_x,
          pad_y,
          pad_click,
          pad_touch,
          grip,
          aim}},
        {"/interaction_profiles/htc/vive_controller",
         "",
         {system, squeeze_click, menu, trigger_click, trigger, pad, pad_x, pad_y, pad_click, pad_touch, grip,
          aim, vibration}},
        {"/interaction_profiles/microsoft/motion_controller",
         "",
         {menu, squeeze_click, trigger, stick, stick_x, stick_y, stick_click, pad, pad_x, pad_y, pad_click,
          pad_touch, grip, aim, vibration}},
        {"/interaction_profiles/microsoft/hand_interaction",
         XR_MSFT_HAND_INTERACTION_EXTENSION_NAME,
         {{"/input/select/value", Kind::number}, squeeze, aim, grip}},
        {"/interaction_profiles/oculus/touch_controller",
         "",
         {{"/input/x/click", Kind::boolean, Side::left},
          {"/input/x/touch", Kind::boolean, Side::left},
          {"/input/y/click", Kind::boolean, Side::left},
          {"/input/y/touch", Kind::boolean, Side::left},
          {"/input/menu/click", Kind::boolean, Side::left},
          {"/input/a/click", Kind::boolean, Side::right},
          {"/input/a/touch", Kind::boolean, Side::right},
          {"/input/b/click", Kind::boolean, Side::right},
          {"/input/b/touch", Kind::boolean, Side::right},
          {"/input/system/click", Kind::boolean, Side::right},
          {"/input/thumbrest/touch", Kind::boolean},
          squeeze,
          trigger,
          trigger_touch,
          stick,
          stick_x,
          stick_y,
          stick_click,
          stick_touch,
          grip,
          aim,
          vibration}},
        {"/interaction_profiles/valve/index_controller",
         "",
         {{"/input/system/touch", Kind::boolean},
          {"/input/a/click", Kind::boolean},
          {"/input/a/touch", Kind::boolean},
          {"/input/b/click", Kind::boolean},
          {"/input/b/touch", Kind::boolean},
          {"/input/squeeze/force", Kind::number},
          {"/input/trackpad/force", Kind::number},
          system,
          squeeze,
          trigger_click,
          trigger,
          trigger_touch,
          stick,
          stick_x,
          stick_y,
          stick_click,
          stick_touch,
          pad,
          pad_x,
          pad_y,
          pad_touch,
          grip,
          aim,
          vibration}},
    };
    return all;
}

const Profile* find(const std::string& name) {
    const auto found = std::find_if(profiles().begin(), profiles().end(),
                                    [&](const Profile& profile) { return profile.name == name; });
    return found == profiles().end() ? nullptr : &*found;
}

constexpr std::string_view hands[] = {"/user/hand/left", "/user/hand/right"};

bool is_on(Side side, std::size_t hand) {
    return side == Side::both || (side == Side::left ? hand == 0 : hand == 1);
}

/// The components that the path names: a single component, or all components below the path.
std::vector<Component> named_by(const std::string& profile_name, const std::string& path) {
    const Profile* const profile = find(profile_name);
    const std::size_t hand = hand_of(path);
    if (!profile || hand >= std::size(hands)) return {};
    const std::string wanted = component_of(path);
    std::vector<Component> out;
    for (const Component& component : profile->components)
        if (is_on(component.side, hand) &&
            (component.path == wanted || std::string_view(component.path).starts_with(wanted + "/")))
            out.push_back(component);
    return out;
}

bool suits(Kind kind, XrActionType type) {
    switch (type) {
        case XR_ACTION_TYPE_BOOLEAN_INPUT:
        case XR_ACTION_TYPE_FLOAT_INPUT:
            return kind == Kind::boolean || kind == Kind::number;
        case XR_ACTION_TYPE_VECTOR2F_INPUT:
            return kind == Kind::vector;
        case XR_ACTION_TYPE_POSE_INPUT:
            return kind == Kind::pose;
        default:
            return kind == Kind::haptic;
    }
}

}  // namespace

bool is_known_profile(const std::string& profile) { return find(profile) != nullptr; }

std::string extension_of_profile(const std::string& profile) { return find(profile)->extension; }

bool has_component(const std::string& profile, const std::string& path) {
    return component_of(path).find('/', 1) != std::string::npos && !named_by(profile, path).empty();
}

bool suits_action(const std::string& profile, const std::string& path, XrActionType type) {
    const std::vector<Component> named = named_by(profile, path);
    return std::any_of(named.begin(), named.end(),
                       [&](const Component& component) { return suits(component.kind, type); });
}

std::size_t hand_of(const std::string& path) {
    const auto found = std::find_if(std::begin(hands), std::end(hands), [&](std::string_view hand) {
        return path == hand || path.starts_with(std::string(hand) + "/");
    });
    return std::size_t(found - std::begin(hands));
}

std::string component_of(const std::string& path) {
    const std::size_t hand = hand_of(path);
    return hand < std::size(hands) ? path.substr(hands[hand].size()) : "";
}

}  // namespace test_runtime
