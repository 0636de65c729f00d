#pragma once
#include <optional>
#include <span>

#include "player/headset/locomotion/locomotion.h"
#include "player/interface/sections/measure_panel.h"
#include "player/interface/state/session.h"
#include "player/panels/marks.h"
#include "player/render/renderer.h"

namespace vantage {

/// Graphics drawn in a headset in addition to the model. Each function appends to `marks`.

/// A hand: its position and its pointing ray, `length` meters long. `meets`: the ray meets an object, so a
/// dot is drawn at its end.
void add_hand(Marks& marks, const Stance& stance, const Hand& hand, double length, bool meets);
/// The dot at the end of the ray of a hand or of the gaze.
void add_dot(Marks& marks, const Stance& stance, const Hand& hand, double length);
/// The arc of a teleport and its landing point.
void add_arc(Marks& marks, const Stance& stance, const TeleportArc& arc);
/// A measurement's points and lines. `origin`: the package's origin, in input coordinates.
void add_measurement(Marks& marks, const Stance& stance, const DrawnMeasurement& drawn,
                     const Eigen::Vector3d& origin, const Eigen::Vector3d& up);
/// The photos of the shown image set as pictures at their cameras, unless the camera is very close to the
/// eye. The photo that is pointed at has a white frame.
void add_photos(Marks& marks, const Stance& stance, Renderer& renderer, const Session& session,
                const Eigen::Vector3d& eye, std::optional<std::uint32_t> pointed_at);
/// A note's anchor.
void add_note(Marks& marks, const Stance& stance, const Eigen::Vector3d& at, bool open);

/// The photo whose picture a ray intersects first, and the distance of that intersection in lengths of the
/// ray's direction.
struct PhotoHit {
    std::uint32_t photo;
    double distance;
};
std::optional<PhotoHit> photo_on(const PlanScene& scene, const Session& session, const Ray& ray,
                                 const Stance& stance);

}  // namespace vantage
