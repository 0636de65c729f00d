#pragma once
#include <optional>

#include "tests/openxr/calls/handles.h"
#include "tests/openxr/world.h"

namespace test_runtime {

/// Ends the call unless the path is XR_NULL_PATH or belongs to the action.
void check_subaction(const Action& action, XrPath path);

/// The pose of the hand to which a pose action is bound, in the stage; nullopt while the hand is inactive.
std::optional<XrPosef> action_pose(XrSession session, const ActionSpace& space, const Moment& moment);

/// The paths to which the session's interaction profile binds an action, for one subaction path or for all.
std::vector<std::string> sources_of(const Session& session, XrAction action, XrPath subaction);

}  // namespace test_runtime
