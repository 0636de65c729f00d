#pragma once
#include <array>
#include <optional>
#include <span>

#include "player/headset/locomotion/hands.h"
#include "player/headset/locomotion/stance.h"
#include "player/headset/scene_interface.h"
#include "player/interface/state/session.h"
#include "player/survey/scene_point.h"
#include "scene/story/story.h"

namespace vantage {

/// The target of a hand's ray.
struct Pointed {
    std::optional<PanelHit> menu{};
    std::optional<std::uint32_t> photo{};
    std::optional<std::size_t> note{};
    std::optional<SurveyPoint> surface{};  ///< while measuring
    double length = 3;                     ///< length of the ray, meters
    bool any() const { return menu || photo || note || surface; }
};

/// Possible targets. The menu occludes all other targets; while measuring, surfaces are targets instead of
/// notes and photos.
struct PointingTargets {
    const std::optional<Panel>& menu;
    std::span<const PlacedMesh> meshes;
    const Eigen::Vector3d& origin;  ///< the package's origin, in input coordinates
    const Story& story;
    const PlanScene& scene;
    const Session& session;
};
Pointed pointed_by(const Hand& hand, const Stance& stance, const PointingTargets& targets);

/// The hand that controls the menu. A hand that pressed its button on the menu controls it until the button
/// is released, even if it no longer points at the menu. Otherwise, the hand that points at the menu controls
/// it, or the right hand if both point at it.
struct MenuPointer {
    std::optional<std::size_t> hand{};
    bool holds = false;  ///< whether the press began in the menu
    PanelPointer pointer{};
};
/// `selected`: whether each hand's button was pressed in the last frame.
MenuPointer next_menu_pointer(MenuPointer last, const Hands& hands, const std::array<Pointed, 2>& pointed,
                              const std::array<bool, 2>& selected, const Stance& stance,
                              const std::optional<Panel>& menu);

}  // namespace vantage
