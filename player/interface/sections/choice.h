#pragma once
#include "player/interface/sections/controls.h"

namespace vantage {

/// A drop-down list for an enum that ends with `count`, with one text per value.
template <class Enum, int count>
void choice(Controls& c, const char* name, Enum& value, const char* const (&texts)[count]) {
    static_assert(count == int(Enum::count));
    int index = int(value);
    if (c.choice(name, &index, texts, count)) value = Enum(index);
}

}  // namespace vantage
