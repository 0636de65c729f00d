#pragma once
#include "base/text/translation.h"
#include "player/survey/units.h"

namespace vantage {

/// Units of length as displayed in lists, in the order of Unit.
inline constexpr const char* unit_texts[] = {MARKED_IN("unit", "unknown"), MARKED_IN("unit", "m"),
                                             MARKED_IN("unit", "cm"),      MARKED_IN("unit", "mm"),
                                             MARKED_IN("unit", "ft"),      MARKED_IN("unit", "in")};
static_assert(sizeof unit_texts / sizeof *unit_texts == std::size_t(Unit::count));

}  // namespace vantage
