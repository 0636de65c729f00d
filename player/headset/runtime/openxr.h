#pragma once
#include <openxr/openxr.h>

namespace vantage {

/// An empty OpenXR structure with its type set.
template <class T>
T typed(XrStructureType type) {
    T out{};
    out.type = type;
    return out;
}

}  // namespace vantage
