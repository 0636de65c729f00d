#pragma once
#include "player/composition/object_set.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// State shown and changed by the sections, in addition to the session.
struct SidebarContent {
    const Renderer& renderer;
    ObjectSet& objects;
    const View& view;  ///< of the picture
};

/// The settings, for experts: groups by task, each with a few controls and the rest behind "More". Returns
/// whether the picture changed in a way that the session does not record.
bool sidebar(Controls& controls, Session& session, const SidebarContent& content, const Area& area,
             double now);

}  // namespace vantage
