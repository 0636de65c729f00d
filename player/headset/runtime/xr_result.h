#pragma once
#include <stdexcept>

#include "player/headset/runtime/openxr.h"

namespace vantage {

/// The session, or the runtime with all that it had, is gone; another one may come.
struct XrLost : std::runtime_error {
    explicit XrLost(bool with_runtime)
        : std::runtime_error(with_runtime ? "the OpenXR runtime was lost" : "the OpenXR session was lost"),
          runtime(with_runtime) {}
    bool runtime;
};

/// Returns a result that is no failure. Throws XrLost for a loss, and Error(graphics) with the name of the
/// call for other failures.
XrResult expect(XrResult result, const char* call);

/// "XR_ERROR_RUNTIME_FAILURE"
const char* name_of(XrResult result);

}  // namespace vantage
