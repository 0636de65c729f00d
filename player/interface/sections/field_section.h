#pragma once
#include "player/interface/sections/controls.h"
#include "player/render/renderer.h"

namespace vantage {

/// The choice of a scalar field, its legend and the value under the pointer; and if `more`, its display. The
/// package must have scalar fields.
void field_section(Controls& controls, FieldSettings& settings, const Renderer& renderer, const View& view,
                   bool more = true);

/// The legend of the shown field, if any, in the lower left corner of an area, for windows without a sidebar.
void field_legend_panel(Controls& controls, const FieldSettings& settings, const Renderer& renderer,
                        const View& view, const Area& area);

}  // namespace vantage
