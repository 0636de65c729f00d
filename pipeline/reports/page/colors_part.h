#pragma once
#include <span>
#include <string>

#include "pipeline/refine/color_agreement.h"
#include "scene/package/package_format.h"

namespace vantage {

/// HTML about the color differences between photos, the gains that correct them (per photo), and the
/// vignetting of the lenses.
std::string colors_part(std::span<const package::PhotoRecord> photos, const ColorRefinement& refinement);

}  // namespace vantage
