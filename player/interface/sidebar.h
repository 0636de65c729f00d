#pragma once
#include "player/composition/object_set.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// The expert's sections, each with a header that opens and closes it. Returns whether something in the
/// picture changed that the session does not tell.
bool sidebar(Controls& controls, Session& session, const Renderer& renderer, ObjectSet& objects,
             const View& view, const Area& area, double now);

}  // namespace vantage
