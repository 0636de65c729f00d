#pragma once
#include <optional>
#include <span>

#include "player/headset/locomotion/locomotion.h"
#include "player/interface/sections/measure_panel.h"
#include "player/interface/state/session.h"
#include "player/panels/marks.h"
#include "player/render/renderer.h"

namespace vantage {

/// What is drawn in the scene of a headset beside the model, each added to `marks`.

/// A hand: where it is, and the ray along which it points, `length` meters long, with a dot at its end if it
/// `meets` something there.
void add_hand(Marks& marks, const Stance& stance, const Hand& hand, double length, bool meets);
/// The dot where a hand, or the gaze, points.
void add_dot(Marks& marks, const Stance& stance, const Hand& hand, double length);
/// The way of a teleport and where it ends.
void add_arc(Marks& marks, const Stance& stance, const TeleportArc& arc);
/// A measurement's points and lines. `origin`: of the package, in the input's coordinates.
void add_measurement(Marks& marks, const Stance& stance, const MeasurePanel::Drawn& drawn,
                     const Eigen::Vector3d& origin, const Eigen::Vector3d& up);
/// The photos of the shown image set as pictures at their cameras, but for those nearer to the eye than a
/// hand's breadth; the one pointed at is framed in white.
void add_photos(Marks& marks, const Stance& stance, Renderer& renderer, const Session& session,
                const Eigen::Vector3d& eye, std::optional<std::uint32_t> pointed_at);
/// A note's anchor.
void add_note(Marks& marks, const Stance& stance, const Eigen::Vector3d& at, bool open);

/// The photo whose picture a ray meets first, and how far away, in lengths of its direction.
struct PhotoHit {
    std::uint32_t photo;
    double distance;
};
std::optional<PhotoHit> photo_on(const PlanScene& scene, const Session& session, const Ray& ray,
                                 const Stance& stance);

}  // namespace vantage
