#pragma once
#include <openxr/openxr.h>

namespace test_runtime {

inline constexpr XrPosef identity_pose = {{0, 0, 0, 1}, {0, 0, 0}};

XrVector3f rotated(const XrQuaternionf& q, const XrVector3f& v);

/// The pose of an object at `inner` in a space whose pose is `outer`.
XrPosef composed(const XrPosef& outer, const XrPosef& inner);
XrPosef inverse(const XrPosef& pose);
/// A pose with the same position and heading, but upright.
XrPosef levelled(const XrPosef& pose);

/// Whether the pose is finite and its rotation has length 1, within the one percent that the specification
/// permits.
bool is_valid(const XrPosef& pose);

}  // namespace test_runtime
