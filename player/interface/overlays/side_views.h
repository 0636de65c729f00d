#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/viewpoint.h"

namespace vantage {

/// Entries of a menu that fly to where the whole model is seen from a side: front, back, left, right, top.
void side_views_menu(Controls& controls, Viewpoint& viewpoint, const PackageReader& package, double now);

}  // namespace vantage
