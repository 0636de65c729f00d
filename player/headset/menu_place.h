#pragma once
#include <optional>

#include "player/headset/locomotion/hands.h"
#include "player/headset/locomotion/stance.h"
#include "player/panels/panel.h"

namespace vantage {

/// Pose of the menu's center in the room; the front of the menu faces the pose's z direction.
struct MenuPlace {
    RoomPose pose;
    struct Held {
        std::size_t hand;
        RoomPose from_hand;  ///< the menu relative to the hand that holds it
    };
    std::optional<Held> held{};
};

/// A place in front of the head, slightly below the eyes, facing the user.
MenuPlace menu_in_front_of(const RoomPose& head);

/// The menu's panel in the scene.
Panel menu_panel(const MenuPlace& place, const Stance& stance, int width, int height);

/// Moves the menu with a hand that squeezes while pointing at the menu; `pointing` is that hand.
void carry(MenuPlace& place, const Hands& hands, std::optional<std::size_t> pointing);

}  // namespace vantage
