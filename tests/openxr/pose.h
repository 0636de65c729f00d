#pragma once
#include <openxr/openxr.h>

namespace test_runtime {

inline constexpr XrPosef identity_pose = {{0, 0, 0, 1}, {0, 0, 0}};

XrVector3f rotated(const XrQuaternionf& q, const XrVector3f& v);

/// The pose of something at `inner` in a space whose own pose is `outer`.
XrPosef composed(const XrPosef& outer, const XrPosef& inner);
XrPosef inverse(const XrPosef& pose);
/// The same place and heading, but upright.
XrPosef levelled(const XrPosef& pose);

/// Whether it is finite and its rotation has length one, within the one percent that the specification
/// allows.
bool is_valid(const XrPosef& pose);

}  // namespace test_runtime
