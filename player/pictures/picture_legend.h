#pragma once
#include "player/render/picture.h"
#include "player/render/render_settings.h"

namespace vantage {

/// Draws the legend of a scalar field into the lower left corner of a picture: name, unit if known, color map
/// with its isolines, and the values at its ends and center. Returns false, and draws nothing, if it would
/// occupy more than half of the width or a third of the height.
bool draw_legend(Picture& picture, const ScalarField& field, const FieldSettings& settings);

}  // namespace vantage
