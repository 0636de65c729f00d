#pragma once
#include "player/interface/sections/controls.h"
#include "player/render/renderer.h"

namespace vantage {

/// The choice and display of a scalar field, with its legend and the value under the pointer. The package
/// must have scalar fields.
void field_section(Controls& controls, FieldSettings& settings, const Renderer& renderer, const View& view);

}  // namespace vantage
