#pragma once
#include "player/composition/object_set.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// What the sections show and change, beside the session.
struct SidebarContent {
    const Renderer& renderer;
    ObjectSet& objects;
    const View& view;  ///< of the picture
};

/// The expert's sections, each with a header that opens and closes it. Returns whether something in the
/// picture changed that the session does not tell.
bool sidebar(Controls& controls, Session& session, const SidebarContent& content, const Area& area,
             double now);

}  // namespace vantage
