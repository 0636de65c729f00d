#pragma once
#include "player/headset/runtime/xr_runtime.h"

namespace vantage {

/// A session that shows what the OpenGL context draws that is current on this thread. Throws Error(graphics)
/// if the runtime does not take it, or XrLost.
XrSession make_session(const XrRuntime& runtime, XrSystemId system);

}  // namespace vantage
