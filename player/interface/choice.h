#pragma once
#include "player/interface/controls.h"

namespace vantage {

/// A list of the values of an enum that ends with `count`, by their names.
template <class Enum, int count>
void choice(Controls& c, const char* name, Enum& value, const char* const (&names)[count]) {
    static_assert(count == int(Enum::count));
    int index = int(value);
    if (c.combo(name, &index, names, count)) value = Enum(index);
}

}  // namespace vantage
