#pragma once
#include <optional>

#include "tests/openxr/calls/handles.h"
#include "tests/openxr/world.h"

namespace test_runtime {

/// Ends the call if the path is neither XR_NULL_PATH nor one of the action.
void check_subaction(const Action& action, XrPath path);

/// The pose of the hand that a pose action has, in the stage; none while it is not active.
std::optional<XrPosef> action_pose(XrSession session, const ActionSpace& space, const Moment& moment);

/// The paths that an action is bound to by the session's interaction profile, of one subaction or of all.
std::vector<std::string> sources_of(const Session& session, XrAction action, XrPath subaction);

}  // namespace test_runtime
