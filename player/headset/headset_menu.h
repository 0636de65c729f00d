#pragma once
#include "player/headset/locomotion/locomotion.h"
#include "player/view/frame_size.h"
#include "player/window/loaded_scene.h"

namespace vantage {

/// The pages of the menu.
enum class MenuPage {
    move,
    photos,
    picture,
    blending,
    fields,
    points,
    image_sets,
    objects,
    cut,
    measure,
    story,
    status,
    count
};

/// State shown and changed by the menu, in addition to the session.
struct MenuContent {
    LoadedScene& scene;
    MenuPage& page;  ///< current page
    Locomotion& locomotion;
    double& unit_meters;  ///< 0: unknown
    bool& vignette;       ///< darkens the edges of the picture while flying
};

/// Draws the headset's menu on a panel of this size, with large controls for the same settings as in the
/// window.
void headset_menu(Controls& controls, Session& session, const MenuContent& content, FrameSize size,
                  double now);

}  // namespace vantage
