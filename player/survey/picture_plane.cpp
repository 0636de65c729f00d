#include "player/survey/picture_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "base/text/error.h"
#include "base/text/formatted.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double least_angle = 1e-6;  ///< radians; smaller angles are treated as zero

/// The numbers in a text, separated by commas or spaces; empty if the text contains anything but finite
/// numbers.
std::vector<double> numbers_in(std::string text) {
    std::ranges::replace(text, ',', ' ');
    std::istringstream in(text);
    std::vector<double> out;
    for (double v; in >> v;) out.push_back(v);
    const bool valid = in.eof() && std::ranges::all_of(out, [](double v) { return std::isfinite(v); });
    return valid ? out : std::vector<double>{};
}

/// The component of `v` perpendicular to the unit vector `axis`, normalized; an arbitrary perpendicular if it
/// is zero.
Vector3d across(const Vector3d& v, const Vector3d& axis) {
    const Vector3d rest = v - axis * axis.dot(v);
    return rest.norm() > least_angle * v.norm() ? Vector3d(rest.normalized()) : axis.unitOrthogonal();
}

/// The direction to the right in the front view: along x, or along y if x is up.
Vector3d right_of_front(const Vector3d& up) {
    const bool x_is_up = std::abs(up.x()) > 0.9;
    return across(x_is_up ? Vector3d::UnitY() : Vector3d::UnitX(), up);
}

[[noreturn]] void refuse(const std::string& text) {
    throw Error(Exit::usage,
                "--plane " + text +
                    ": expected top, bottom, front, back, left, right, or a point, a normal toward the "
                    "viewer and the picture's up direction: PX,PY,PZ,NX,NY,NZ[,UX,UY,UZ]");
}

}  // namespace

PicturePlane parse_plane(const std::string& text, const Vector3d& scene_up) {
    const Vector3d up = scene_up, right = right_of_front(up), ahead = up.cross(right);
    struct Named {
        const char* name;
        Vector3d right, up;
    };
    const std::array<Named, 6> named{{{"top", right, ahead},
                                      {"bottom", right, -ahead},
                                      {"front", right, up},
                                      {"back", -right, up},
                                      {"left", -ahead, up},
                                      {"right", ahead, up}}};
    for (const Named& n : named)
        if (text == n.name) return {Vector3d::Zero(), n.right, n.up};
    const std::vector<double> v = numbers_in(text);
    if (v.size() != 6 && v.size() != 9) refuse(text);
    const Vector3d normal(v[3], v[4], v[5]);
    const Vector3d wanted = v.size() == 9 ? Vector3d(v[6], v[7], v[8]) : scene_up;
    if (!(normal.stableNorm() > 0) || !(wanted.stableNorm() > 0)) refuse(text);
    const Vector3d toward = normal.stableNormalized(), upward = wanted.stableNormalized();
    if (v.size() == 9 && upward.cross(toward).norm() <= least_angle) refuse(text);
    const Vector3d in_picture = across(upward, toward);
    return {{v[0], v[1], v[2]}, in_picture.cross(toward), in_picture};
}

Eigen::AlignedBox2d extent_on(const PicturePlane& plane, const package::SceneRecord& scene) {
    const Eigen::AlignedBox3d box(Eigen::Map<const Vector3d>(scene.bounds_min),
                                  Eigen::Map<const Vector3d>(scene.bounds_max));
    Eigen::AlignedBox2d out;
    for (int i = 0; i < 8; ++i) {
        const Vector3d p = box.corner(Eigen::AlignedBox3d::CornerType(i)) - plane.origin;
        out.extend(Eigen::Vector2d(plane.right.dot(p), plane.up.dot(p)));
    }
    return out;
}

Eigen::AlignedBox2d parse_extent(const std::string& text) {
    const std::vector<double> v = numbers_in(text);
    if (v.size() != 4 || !(v[0] < v[2]) || !(v[1] < v[3]))
        throw Error(Exit::usage,
                    "--extent " + text + ": expected LEFT,BOTTOM,RIGHT,TOP in units of the plane");
    return {Eigen::Vector2d(v[0], v[1]), Eigen::Vector2d(v[2], v[3])};
}

SectionPlane parse_section(const std::string& text, const Vector3d& origin) {
    const std::vector<double> v = numbers_in(text);
    const Vector3d normal = v.size() == 6 ? Vector3d(v[3], v[4], v[5]) : Vector3d::Zero();
    if (!(normal.stableNorm() > 0))
        throw Error(Exit::usage, "--cut " + text +
                                     ": expected a point on the plane and the normal toward the removed "
                                     "part: PX,PY,PZ,NX,NY,NZ");
    const Vector3d toward = normal.stableNormalized();
    return {toward, toward.dot(Vector3d(v[0], v[1], v[2]) - origin)};
}

std::string section_text(const SectionPlane& s, const Vector3d& origin) {
    const Vector3d at = origin + s.offset * s.normal, &n = s.normal;
    return formatted("%.15g,%.15g,%.15g,%.15g,%.15g,%.15g", at.x(), at.y(), at.z(), n.x(), n.y(), n.z());
}

std::string world_file_text(const Eigen::Vector2d& upper_left, double resolution) {
    const double half = resolution / 2;
    return formatted("%.15g\n0\n0\n%.15g\n%.15g\n%.15g\n", resolution, -resolution, upper_left.x() + half,
                     upper_left.y() - half);
}

}  // namespace vantage
