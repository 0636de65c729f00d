#include "player/headset/runtime/xr_result.h"

#include <openxr/openxr_reflection.h>

#include <string>

#include "base/text/error.h"

namespace vantage {

const char* name_of(XrResult result) {
    switch (result) {
#define VANTAGE_NAME(name, value) \
    case name:                    \
        return #name;
        XR_LIST_ENUM_XrResult(VANTAGE_NAME)
#undef VANTAGE_NAME
    }
    return "an unknown result";
}

XrResult expect(XrResult result, const char* call) {
    if (XR_SUCCEEDED(result)) return result;
    if (result == XR_ERROR_SESSION_LOST) throw XrLost(false);
    if (result == XR_ERROR_INSTANCE_LOST) throw XrLost(true);
    throw Error(Exit::graphics, std::string("OpenXR: ") + call + ": " + name_of(result));
}

}  // namespace vantage
