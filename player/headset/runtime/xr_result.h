#pragma once
#include <stdexcept>

#include "player/headset/runtime/openxr.h"

namespace vantage {

/// The session was lost, or the runtime and everything created from it were lost. Either may become available
/// again.
struct XrLost : std::runtime_error {
    explicit XrLost(bool with_runtime)
        : std::runtime_error(with_runtime ? "the OpenXR runtime was lost" : "the OpenXR session was lost"),
          runtime(with_runtime) {}
    bool runtime;
};

/// Returns a successful result. Throws XrLost if the session or the runtime was lost, and Error(graphics)
/// with the name of the call for other failures.
XrResult expect(XrResult result, const char* call);

/// The name of a result, such as "XR_ERROR_RUNTIME_FAILURE".
const char* name_of(XrResult result);

}  // namespace vantage
