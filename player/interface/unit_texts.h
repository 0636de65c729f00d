#pragma once
#include "base/text/translation.h"
#include "player/survey/units.h"

namespace vantage {

/// Units of length as a list shows them, in the order of Unit.
inline constexpr const char* unit_texts[] = {marked("unknown"), marked("m"),  marked("cm"),
                                             marked("mm"),      marked("ft"), marked("in")};
static_assert(sizeof unit_texts / sizeof *unit_texts == std::size_t(Unit::count));

}  // namespace vantage
