#pragma once
#include <optional>

#include "player/headset/locomotion/hands.h"
#include "player/headset/locomotion/stance.h"
#include "player/panels/panel.h"

namespace vantage {

/// Where in the room the menu is: its middle; its front faces along the pose's z.
struct MenuPlace {
    RoomPose pose;
    struct Held {
        std::size_t hand;
        RoomPose from_hand;  ///< the menu, as seen from the hand that holds it
    };
    std::optional<Held> held{};
};

/// In front of somebody, a little below the eyes, facing them.
MenuPlace menu_in_front_of(const RoomPose& head);

/// The menu's panel in the scene.
Panel menu_panel(const MenuPlace& place, const Stance& stance, int width, int height);

/// Moves with the hand that squeezes while it points at the menu, `pointing` being that hand.
void carry(MenuPlace& place, const Hands& hands, std::optional<std::size_t> pointing);

}  // namespace vantage
