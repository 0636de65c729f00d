#pragma once
#include <vector>

#include "player/headset/runtime/xr_result.h"

namespace vantage {

/// All elements listed by an OpenXR function, which is called once for their number and once for the
/// elements. `call(capacity, count, elements)` calls that function and returns its result; `empty` is an
/// element with its type set. Throws the errors of expect().
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
