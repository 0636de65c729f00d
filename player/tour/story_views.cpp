#include "player/tour/story_views.h"

#include <cmath>

#include "base/text/error.h"

namespace vantage {
InputAxes input_axes(const PackageReader& package) {
    return {Eigen::Map<const Eigen::Vector3d>(package.scene().origin), up_of(package.scene())};
}

Navigation camera_at(const StoryView& view, const InputAxes& axes) {
    const Eigen::Vector3d up = view.up ? view.up->normalized() : axes.up;
    const Eigen::Vector3d eye = view.eye - axes.origin, target = view.target - axes.origin;
    const Eigen::Matrix3d level = view_towards(eye, target, up, view.fov, 1, 1).cam_from_origin.R;
    return {eye, target, up, rolled(level, view.roll), view.fov};
}

std::vector<Ball> hidden_balls(const Story& story, const InputAxes& axes) {
    std::vector<Ball> out;
    for (const StoryBall& ball : story.hidden) out.push_back({ball.center - axes.origin, ball.radius});
    return out;
}

double rounded_length(double length, double distance) {
    // Uses either the power of ten or its inverse, whichever is an integer and therefore exact. This yields
    // short decimals.
    const double exponent = std::floor(std::log10(std::max(distance, 1e-9) * 1e-6));
    const double whole = std::pow(10, std::abs(exponent));
    return exponent < 0 ? std::round(length * whole) / whole : std::round(length / whole) * whole;
}

Eigen::Vector3d rounded_place(const Eigen::Vector3d& place, double distance) {
    return place.unaryExpr([&](double x) { return rounded_length(x, distance); });
}

StoryView story_view(const Navigation& camera, const InputAxes& axes) {
    const double distance = std::max((camera.target - camera.eye).norm(), 1e-9);
    const Eigen::Vector3d target = camera.eye + distance * camera.R.row(2).transpose();
    StoryView out{rounded_place(camera.eye + axes.origin, distance),
                  rounded_place(target + axes.origin, distance)};
    if (!camera.up.isApprox(axes.up, 1e-6)) out.up = camera.up;
    out.roll = std::round(roll_of(camera.R, camera.up) * 1e4) / 1e4;
    out.fov = std::round(camera.fov * 1e4) / 1e4;
    return out;
}

std::vector<KeyView> keys_of(const Story& story, const std::vector<StoryStop>& stops,
                             const std::optional<Navigation>& start, const InputAxes& axes,
                             const std::string& story_file) {
    std::vector<KeyView> keys;
    if (start) keys.push_back({*start, 0});
    double now = 0;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const StoryView* view = view_of_stop(story, stops[i]);
        if (!view)
            throw Error(Exit::input, story_file + ": stops[" + std::to_string(i) + "].note: found \"" +
                                         stops[i].note + "\", expected a note that has a view");
        if (!keys.empty()) now += stops[i].fly;
        const Navigation camera = camera_at(*view, axes);
        keys.push_back({camera, now});
        if (stops[i].stay > 0) keys.push_back({camera, now += stops[i].stay});
    }
    return keys;
}

}  // namespace vantage
