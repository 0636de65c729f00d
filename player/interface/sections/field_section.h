#pragma once
#include "player/interface/sections/controls.h"
#include "player/render/renderer.h"

namespace vantage {

/// Which scalar field is shown and how, with its legend and the value under the pointer. The
/// package must have fields.
void field_section(Controls& controls, FieldSettings& settings, const Renderer& renderer, const View& view);

}  // namespace vantage
