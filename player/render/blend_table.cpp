#include "player/render/blend_table.h"

#include <algorithm>
#include <array>

namespace vantage {
namespace {

constexpr std::array table{
    BlendRow{Blend::lumigraph, "lumigraph", "Lumigraph",
             "by the angle between the rays to viewer and photo, fading at borders", "BLEND_LUMIGRAPH",
             false},
    BlendRow{Blend::average, "average", "Average", "by distance, angle and all masks", "", false},
    BlendRow{Blend::best, "best", "Best photo", "each point from one photo", "BLEND_BEST", true},
};
static_assert(table.size() == std::size_t(Blend::count), "each mode has a row");

}  // namespace

std::span<const BlendRow> blend_table() { return table; }

const BlendRow& blend_row(Blend blend) { return *std::ranges::find(table, blend, &BlendRow::blend); }

}  // namespace vantage
