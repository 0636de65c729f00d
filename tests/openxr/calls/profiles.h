#pragma once
// The interaction profiles of the specification, with the inputs of controllers.
#include <openxr/openxr.h>

#include <string>

namespace test_runtime {

bool is_known_profile(const std::string& profile);
/// The extension that the profile requires; empty if none.
std::string extension_of_profile(const std::string& profile);

/// has_component(): whether the controller has a path such as /user/hand/left/input/trigger/value. The path
/// /user/hand/left/input/trigger stands for any of its components. suits_action(): whether an action of this
/// type can be bound to the path.
bool has_component(const std::string& profile, const std::string& path);
bool suits_action(const std::string& profile, const std::string& path, XrActionType type);

/// The hand to which the path belongs: 0 is left, 1 is right. Any other value means that the path belongs to
/// neither hand.
std::size_t hand_of(const std::string& path);
/// "/input/trigger/value"
std::string component_of(const std::string& path);

}  // namespace test_runtime
