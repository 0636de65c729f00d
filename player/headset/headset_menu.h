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

/// What the menu shows and changes, beside the session.
struct MenuContent {
    LoadedScene& scene;
    MenuPage& page;  ///< that is shown
    Locomotion& locomotion;
    double& unit_meters;  ///< 0: unknown
    bool& vignette;       ///< while flying, the edges of the picture are dark
};

/// The menu in a headset, on a panel of this size, with large controls: the same settings as the window's.
void headset_menu(Controls& controls, Session& session, const MenuContent& content, FrameSize size,
                  double now);

}  // namespace vantage
