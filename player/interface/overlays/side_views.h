#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// Menu entries that fly to views of the whole model from a side: front, back, left, right, top.
void side_views_menu(Controls& controls, Session& session, const PackageReader& package, double now);

}  // namespace vantage
