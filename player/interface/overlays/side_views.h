#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// Entries of a menu that fly to where the whole model is seen from a side: front, back, left, right, top.
void side_views_menu(Controls& controls, Session& session, const PackageReader& package, double now);

}  // namespace vantage
