#include "player/interface/state/viewpoint.h"

#include <algorithm>
#include <cmath>

#include "player/view/camera_path.h"

namespace vantage {

void begin_at(Viewpoint& v, const Navigation& camera) { v.camera = v.home = v.earlier.last = camera; }

void start_flight(Viewpoint& v, const Navigation& to, double now, double seconds) {
    v.flight = Viewpoint::Flight{{v.camera, to}, now, seconds};
}

void fly_to_point(Viewpoint& v, const Eigen::Vector3d& point, double now) {
    start_flight(v, facing(v.camera, point, (v.camera.eye - point).norm() / 2), now, 0.5);
}

void replay(Viewpoint& v, const RecordedPath& path, double now) {
    if (path.positions.size() < 2) return;
    v.flight =
        Viewpoint::Flight{path.positions, now, double(path.positions.size() - 1) / positions_per_second};
}

namespace {

/// Delays a flight that stands at a stop while the picture is not final.
void wait_at_stop(Viewpoint::Flight& f, const Navigation& camera, double now, bool final) {
    constexpr double longest = 15, soon = 0.1;  // seconds
    const Navigation next = f.along->at(std::min(now, f.continued + soon) - f.start);
    if (next.eye != camera.eye || next.R != camera.R)
        f.waited = 0;
    else if (!final && f.waited < longest) {
        f.start += now - f.continued;
        f.waited += now - f.continued;
    }
    f.continued = now;
}

}  // namespace

void continue_flight(Viewpoint& v, double now, bool final) {
    if (!v.flight) return;
    if (v.flight->along) {
        wait_at_stop(*v.flight, v.camera, now, final);
        v.camera = v.flight->along->at(now - v.flight->start);
        if (now - v.flight->start >= v.flight->seconds) v.flight.reset();
        return;
    }
    const auto& stops = v.flight->stops;
    if (v.flight->repeats)
        v.flight->start += std::floor((now - v.flight->start) / v.flight->seconds) * v.flight->seconds;
    double share = std::clamp((now - v.flight->start) / v.flight->seconds, 0.0, 1.0);
    if (stops.size() == 2) share = share * share * (3 - 2 * share);  // accelerates and decelerates smoothly
    const double at = share * double(stops.size() - 1);
    const auto first = std::min(std::size_t(at), stops.size() - 2);
    v.camera = share >= 1 ? stops.back() : between(stops[first], stops[first + 1], at - double(first));
    if (share >= 1) v.flight.reset();
}

std::optional<double> end_of_flight(const Viewpoint& v) {
    return v.flight ? std::optional(v.flight->start + v.flight->seconds) : std::nullopt;
}

void note_view(Viewpoint& v, double now) {
    constexpr double pause = 0.5;  // shortest pause between two movements, in seconds
    constexpr std::size_t most = 100;
    Viewpoint::EarlierViews& e = v.earlier;
    if (v.camera.eye != e.last.eye || v.camera.R != e.last.R) {
        if (now - e.moved_at > pause && !e.returning) e.views.push_back(e.last);
        if (e.views.size() > most) e.views.erase(e.views.begin());
        e.moved_at = now;
        e.last = v.camera;
    }
    e.returning = e.returning && v.flight;
}

void toggle_recording(RecordedPath& path) {
    path.recording = !path.recording;
    if (path.recording) path.positions.clear();
}

}  // namespace vantage
