#include "player/interface/state/session.h"

#include <algorithm>

#include "base/text/translation.h"
#include "player/plan/plan_scene.h"
#include "player/view/camera_path.h"

namespace vantage {

View shown_view(const Navigation& camera, const Session& s, const PlanScene& scene, int width, int height) {
    const View view = view_of(camera, width, height, s.window.free);
    const double distance = (camera.target - camera.eye).norm();
    if (!s.orthographic || !(distance > 0)) return view;
    return orthographic(view, distance, std::max(scene.size, distance));
}

bool& layers_open(Session& s) { return s.measured_layers ? *s.measured_layers : s.window.panels.layers; }

void fly_to(Session& s, std::uint32_t photo, const package::PhotoRecord& record, double now) {
    s.standing_at = photo;
    s.settings.compare_photo = photo;
    s.orthographic = false;  // no photo is
    s.flight = Session::Flight{{s.camera, stand_at(record, s.camera.up)}, now, 0.7};
}

void fly_home(Session& s, double now) {
    s.settings.compare = Compare::nothing;
    s.flight = Session::Flight{{s.camera, s.home}, now, 0.7};
}

void fly_to_point(Session& s, const Eigen::Vector3d& point, double now) {
    s.flight =
        Session::Flight{{s.camera, facing(s.camera, point, (s.camera.eye - point).norm() / 2)}, now, 0.5};
}

void note_time(Session& s, double ms) {
    std::rotate(s.frame_ms.begin(), s.frame_ms.begin() + 1, s.frame_ms.end());
    s.frame_ms.back() = float(ms);
    std::vector<double> drawn;
    for (const float t : s.frame_ms)
        if (t > 0) drawn.push_back(double(t));
    s.statistics = frame_statistics(std::move(drawn));
}

void note_view(Session& s, double now) {
    constexpr double pause = 0.5;  // seconds between two movements
    constexpr std::size_t most = 100;
    Session::EarlierViews& e = s.earlier;
    if (s.camera.eye != e.last.eye || s.camera.R != e.last.R) {
        if (now - e.moved_at > pause && !e.returning) e.views.push_back(e.last);
        if (e.views.size() > most) e.views.erase(e.views.begin());
        e.moved_at = now;
        e.last = s.camera;
    }
    e.returning = e.returning && s.flight;
}

void fly_back(Session& s, double now) {
    Session::EarlierViews& e = s.earlier;
    if (e.views.empty()) return say(s.message, tr("This is the first view"), now);
    s.flight = Session::Flight{{s.camera, e.views.back()}, now, 0.4};
    e.views.pop_back();
    e.returning = true;
}

void replay(Session& s, double now) {
    if (s.recorded.size() < 2) return;
    s.flight = Session::Flight{s.recorded, now, double(s.recorded.size() - 1) / positions_per_second};
}

void continue_flight(Session& s, double now) {
    if (!s.flight) return;
    if (s.flight->along) {
        s.camera = s.flight->along->at(now - s.flight->start);
        if (now - s.flight->start >= s.flight->seconds) s.flight.reset();
        return;
    }
    const auto& stops = s.flight->stops;
    double share = std::clamp((now - s.flight->start) / s.flight->seconds, 0.0, 1.0);
    if (stops.size() == 2) share = share * share * (3 - 2 * share);  // accelerates and decelerates smoothly
    const double at = share * double(stops.size() - 1);
    const auto first = std::min(std::size_t(at), stops.size() - 2);
    s.camera = share >= 1 ? stops.back() : between(stops[first], stops[first + 1], at - double(first));
    if (share >= 1) s.flight.reset();
}

}  // namespace vantage
