#include "player/view/navigation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/package/contents/first_photo.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

constexpr double pole_limit = 87 * std::numbers::pi / 180;  // of the angle above or below the horizon

/// The rotation of the world for the angles `right` and `down`, which stops 3 degrees from the poles.
Eigen::Matrix3d turn(const Navigation& n, double right, double down) {
    const Eigen::Vector3d x = n.R.row(0), ahead = n.R.row(2);
    const double above = std::asin(std::clamp(ahead.dot(n.up), -1.0, 1.0));
    const double reached =
        std::clamp(above - down, std::min(-pole_limit, above), std::max(pole_limit, above));
    // Camera y points down, so a positive rotation about x looks up.
    return (Eigen::AngleAxisd(-right, n.up) * Eigen::AngleAxisd(reached - above, x)).toRotationMatrix();
}

}  // namespace

Navigation stand_at(const package::PhotoRecord& photo, const Eigen::Vector3d& up) {
    const Pose pose = cam_from_origin(photo);
    return {pose.center(),
            pose.center() + seen_distance(photo) * pose.direction(),
            up,
            pose.R,
            2 * std::atan(photo.height / (2 * photo.fy)) * 180 / std::numbers::pi,
            double(photo.width) / photo.height};
}

Navigation stand_at(const View& v, const Eigen::Vector3d& up, double distance) {
    const Eigen::Vector3d eye = v.cam_from_origin.center();
    return {eye, eye + distance * v.cam_from_origin.direction(), up, v.cam_from_origin.R,
            2 * std::atan(v.intrinsics.height / (2 * v.intrinsics.fy)) * 180 / std::numbers::pi};
}

namespace {

constexpr double fov_of_all = 45;  // degrees

/// The distance from which the whole model is visible, with a margin.
double distance_to_all(const package::SceneRecord& scene) {
    constexpr double margin = 1.1;
    const Eigen::Map<const Eigen::Vector3d> low(scene.bounds_min), high(scene.bounds_max);
    const double radius = std::max((high - low).norm() / 2, 1e-6);
    return radius * margin / std::sin(fov_of_all / 2 * std::numbers::pi / 180);
}

}  // namespace

Navigation stand_before(const package::SceneRecord& scene, const Eigen::Vector3d& up) {
    const Eigen::Vector3d across = up.unitOrthogonal(),
                          eye = (across + 0.5 * up).normalized() * distance_to_all(scene);
    return {eye,        Eigen::Vector3d::Zero(),
            up,         view_towards(eye, Eigen::Vector3d::Zero(), up, fov_of_all, 1, 1).cam_from_origin.R,
            fov_of_all, 1};
}

Navigation stand_beside(const package::SceneRecord& scene, const Eigen::Vector3d& right,
                        const Eigen::Vector3d& picture_up, const Eigen::Vector3d& up) {
    const Eigen::Vector3d toward = right.cross(picture_up);
    Navigation n{{}, bounds_from_origin(scene).center(), up, {}, fov_of_all, 1};
    n.eye = n.target + toward * distance_to_all(scene);
    n.R << right.transpose(), -picture_up.transpose(), -toward.transpose();
    return n;
}

Navigation home_of(const PackageReader& package, std::uint32_t photo) {
    const auto photos = package.photos();
    const Eigen::Vector3d up = up_of(package.scene());
    return photo < photos.size() ? stand_at(photos[photo], up) : stand_before(package.scene(), up);
}

Navigation first_view(const PackageReader& package, std::uint32_t image_set) {
    const package::SceneRecord& scene = package.scene();
    const std::uint32_t photo = first_photo(package, image_set);
    if (photo != scene.first_photo) return home_of(package, photo);
    const Eigen::Vector3d up = up_of(scene), eye = cam_from_origin(package.photos()[photo]).center(),
                          target(scene.first_target);
    if (!((target - eye).norm() > 0)) return home_of(package, photo);
    const View view = view_towards(eye, target, up, scene.first_fov, 1, 1);
    return {eye, target, up, view.cam_from_origin.R, scene.first_fov, scene.first_aspect};
}

std::optional<Navigation> leveled(const Navigation& n) {
    constexpr double least = 0.1;  // degrees
    const double roll = roll_of(n.R, n.up);
    if (std::abs(roll) < least || std::abs(n.R.row(2).dot(n.up)) > std::sin(pole_limit)) return {};
    Navigation out = n;
    out.R = rolled(n.R, -roll);
    return out;
}

void look(Navigation& n, double right, double down) {
    const Eigen::Matrix3d world = turn(n, right, down);
    n.R = n.R * world.transpose();
    n.target = n.eye + world * (n.target - n.eye);
}

void orbit_about(Navigation& n, const Eigen::Vector3d& pivot, double right, double down) {
    const Eigen::Matrix3d world = turn(n, right, down);
    n.R = n.R * world.transpose();
    n.eye = pivot + world * (n.eye - pivot);
    n.target = pivot + world * (n.target - pivot);
}

void orbit(Navigation& n, double right, double down) { orbit_about(n, n.target, right, down); }

void fly(Navigation& n, const Eigen::Vector3d& step) {
    const Eigen::Vector3d moved = n.R.transpose() * step;
    n.eye += moved;
    n.target += moved;
}

void approach(Navigation& n, double factor) {
    const double distance = (n.eye - n.target).norm();
    if (distance > 0) n.eye = n.target + (n.eye - n.target) * std::clamp(factor, 0.01, 100.0);
}

void approach_point(Navigation& n, const Eigen::Vector3d& point, double factor, double nearest,
                    double farthest) {
    const double distance = (n.eye - point).norm();
    if (!(distance > 0)) return;
    // If the eye is beyond a limit, it may only move back toward that limit.
    const double least = std::min(nearest, distance), most = std::max(farthest, distance),
                 scale = std::clamp(distance * factor, least, most) / distance;
    n.eye = point + scale * (n.eye - point);
    n.target = point + scale * (n.target - point);
}

Navigation facing(const Navigation& n, const Eigen::Vector3d& point, double distance) {
    Navigation out = n;
    out.target = point;
    out.eye = point - distance * Eigen::Vector3d(n.R.row(2));
    return out;
}

View view_of(const Navigation& n, int width, int height) {
    const double f = height / (2 * std::tan(n.fov * std::numbers::pi / 360));
    Pose pose{n.R, -n.R * n.eye};
    return {{width, height, f, f, width / 2.0, height / 2.0}, pose};
}

View view_of(const Navigation& n, int width, int height, const Area& free) {
    View view = view_of(n, width, height);
    const double high = std::max(1.0, free.height), wide = std::max(1.0, free.width);
    const double fitted = n.aspect > 0 ? std::min(high, wide / n.aspect) : high;
    Intrinsics& k = view.intrinsics;
    k.fx = k.fy = fitted / (2 * std::tan(n.fov * std::numbers::pi / 360));
    k.cx = free.left + wide / 2;
    k.cy = free.top + high / 2;
    return view;
}

}  // namespace vantage
