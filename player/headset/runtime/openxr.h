#pragma once
#include <openxr/openxr.h>

namespace vantage {

/// An empty structure of OpenXR that says what it is.
template <class T>
T typed(XrStructureType type) {
    T out{};
    out.type = type;
    return out;
}

}  // namespace vantage
