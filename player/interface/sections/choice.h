#pragma once
#include "player/interface/sections/controls.h"

namespace vantage {

/// A drop-down list for an enum that ends with `count`, with one text per value. Returns whether the value
/// was changed.
template <class Enum, int count>
bool choice(Controls& c, const char* name, Enum& value, const char* const (&texts)[count]) {
    static_assert(count == int(Enum::count));
    int index = int(value);
    const bool changed = c.choice(name, &index, texts, count);
    if (changed) value = Enum(index);
    return changed;
}

}  // namespace vantage
