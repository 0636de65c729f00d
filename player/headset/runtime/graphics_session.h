#pragma once
#include "player/headset/runtime/xr_runtime.h"

namespace vantage {

/// A session for the OpenGL context that is current on this thread. Throws Error(graphics) if the runtime
/// does not support the context, or XrLost.
XrSession make_session(const XrRuntime& runtime, XrSystemId system);

}  // namespace vantage
