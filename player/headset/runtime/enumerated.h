#pragma once
#include <vector>

#include "player/headset/runtime/xr_result.h"

namespace vantage {

/// All elements that a function of OpenXR lists, which is asked for their number first. `call`: of (capacity,
/// count, elements), returning its result; `empty`: an element, with its type. Throws as expect() does.
template <class T, class Call>
std::vector<T> enumerated(const char* name, const T& empty, const Call& call) {
    std::uint32_t count = 0;
    expect(call(0u, &count, static_cast<T*>(nullptr)), name);
    std::vector<T> out(count, empty);
    expect(call(count, &count, out.data()), name);
    out.resize(count, empty);
    return out;
}

}  // namespace vantage
