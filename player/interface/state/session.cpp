#include "player/interface/state/session.h"

#include <algorithm>

#include "base/text/translation.h"
#include "player/plan/plan_scene.h"
#include "player/tour/attract_loop.h"

namespace vantage {

View shown_view(const Navigation& camera, const Session& s, const PlanScene& scene, int width, int height) {
    const View view = view_of(camera, width, height, s.window.picture);
    const double distance = (camera.target - camera.eye).norm();
    if (!s.viewpoint.orthographic || !(distance > 0)) return view;
    return orthographic(view, distance, std::max(scene.size, distance));
}

void fly_to(Session& s, std::uint32_t photo, const package::PhotoRecord& record, double now) {
    Viewpoint& v = s.viewpoint;
    v.standing_at = s.settings.compare_photo = photo;
    if (s.settings.exposure) s.settings.exposure = photo;
    v.orthographic = false;  // photos are in perspective
    start_flight(v, stand_at(record, v.camera.up), now, 0.7);
}

void fly_level(Session& s, double now) {
    if (const auto level = leveled(s.viewpoint.camera)) start_flight(s.viewpoint, *level, now, 0.4);
}

void toggle_rotation(Session& s, std::span<const package::PhotoRecord> photos, double now) {
    constexpr double seconds_per_degree = 0.25;
    Viewpoint& v = s.viewpoint;
    if (rotates(v)) return v.flight.reset();
    const Arc arc = s.movement.near_photos ? arc_near_photos(photos, v.camera) : Arc{};
    const double degrees = arc.to - arc.from, path = degrees < 360 ? 2 * degrees : 360;
    const AttractLoop loop = turn_around(v.camera, std::max(1.0, path * seconds_per_degree), arc);
    v.flight = Viewpoint::Flight{loop.positions, now, loop.seconds, {}, true};
}

void fly_home(Session& s, double now) {
    s.settings.compare = Compare::nothing;
    start_flight(s.viewpoint, s.viewpoint.home, now, 0.7);
}

void fly_back(Session& s, double now) {
    Viewpoint::EarlierViews& e = s.viewpoint.earlier;
    if (e.views.empty()) return say(s.message, tr("This is the first view"), now);
    start_flight(s.viewpoint, e.views.back(), now, 0.4);
    e.views.pop_back();
    e.returning = true;
}

}  // namespace vantage
