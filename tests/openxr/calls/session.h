#pragma once
#include "tests/openxr/calls/handles.h"

namespace test_runtime {

std::vector<XrSession> sessions_of(XrInstance instance);

/// Destroys a session and all its objects.
void end_all_of(XrSession session);

}  // namespace test_runtime
