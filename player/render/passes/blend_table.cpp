#include "player/render/passes/blend_table.h"

#include <algorithm>
#include <array>

#include "base/text/translation.h"

namespace vantage {
namespace {

constexpr std::array table{
    BlendRow{Blend::lumigraph, "lumigraph", marked("Lumigraph"),
             marked("by the angle between the rays to the viewer and to the photo, fading at borders"),
             "BLEND_LUMIGRAPH", true, false},
    BlendRow{Blend::average, "average", marked("Average"), marked("by distance, angle and all weights"), "",
             true, false},
    BlendRow{Blend::best, "best", marked("Best photo"), marked("each point from one photo"), "BLEND_BEST",
             false, true},
};
static_assert(table.size() == std::size_t(Blend::count), "each mode has a row");

}  // namespace

std::span<const BlendRow> blend_table() { return table; }

const BlendRow& blend_row(Blend blend) { return *std::ranges::find(table, blend, &BlendRow::blend); }

}  // namespace vantage
