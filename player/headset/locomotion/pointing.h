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

/// What a hand points at.
struct Pointed {
    std::optional<PanelHit> menu{};
    std::optional<std::uint32_t> photo{};
    std::optional<std::size_t> note{};
    std::optional<SurveyPoint> surface{};  ///< while it measures
    double length = 3;                     ///< of its ray, meters
    bool any() const { return menu || photo || note || surface; }
};

/// What there is to point at. The menu hides everything else; while the session measures, there are surfaces
/// instead of notes and photos.
struct PointingTargets {
    const std::optional<Panel>& menu;
    std::span<const PlacedMesh> meshes;
    const Eigen::Vector3d& origin;  ///< of the package, in the input's coordinates
    const Story& story;
    const PlanScene& scene;
    const Session& session;
};
Pointed pointed_by(const Hand& hand, const Stance& stance, const PointingTargets& targets);

/// The menu's pointer: that of the hand that pressed there, as long as it presses, also beside the menu;
/// otherwise of the one that points at it, of the right one if both do.
struct MenuPointer {
    std::optional<std::size_t> hand{};
    bool holds = false;  ///< it was pressed there
    PanelPointer pointer{};
};
/// `selected`: which hands did so in the last frame.
MenuPointer next_menu_pointer(MenuPointer last, const Hands& hands, const std::array<Pointed, 2>& pointed,
                              const std::array<bool, 2>& selected, const Stance& stance,
                              const std::optional<Panel>& menu);

}  // namespace vantage
