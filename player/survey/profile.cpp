#include "player/survey/profile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text/translation.h"
#include "player/plan/triangle_corners.h"
#include "player/survey/footprint.h"
#include "player/survey/number_text.h"
#include "player/survey/section.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr std::size_t profile_steps = 400;
constexpr double near_line = 0.1;             ///< distance of the averaged surface, in lengths of the line
constexpr double sine_20 = 0.34202014332567;  ///< within 20 degrees, normals become vertical or horizontal
constexpr double sine_5 = 0.08715574274766;   ///< least angle between the line and the normal

/// The point of a triangle that is nearest to p.
Vector3d nearest_on(const Corners& c, const Vector3d& p) {
    const Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
    const Vector3d below = p - normal * (normal.dot(p - c[0]) / normal.squaredNorm());
    bool inside = below.allFinite();
    Vector3d out = c[0];
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3d edge = c[(i + 1) % 3] - c[i];
        inside = inside && normal.dot(edge.cross(below - c[i])) >= 0;
        const double share = edge.dot(p - c[i]) / edge.squaredNorm();
        const Vector3d at = c[i] + std::clamp(share, 0.0, 1.0) * edge;
        if ((at - p).squaredNorm() < (out - p).squaredNorm()) out = at;
    }
    return inside ? below : out;
}

/// A line between two points, relative to the scene's origin.
using Ends = std::array<Vector3d, 2>;

Vector3d nearest_on(const Ends& line, const Vector3d& p) {
    const Vector3d step = line[1] - line[0];
    const double share = step.dot(p - line[0]) / step.squaredNorm();
    return line[0] + (share > 0 ? std::min(share, 1.0) : 0.0) * step;
}

struct NearTriangle {
    const PlacedMesh* mesh;
    std::uint32_t number;
    Vector3d area;  ///< the normal, as long as the area is large
    Vector3d at;    ///< its point near the line, relative to the scene's origin
    double distance;
};

/// Calls visit(NearTriangle) for the triangles within `reach` of a line; visit may reduce `reach`.
template <class Visit>
void visit_near(std::span<const PlacedMesh> meshes, const Ends& line, const double& reach,
                const Visit& visit) {
    for (const PlacedMesh& m : meshes)
        for (const package::ClusterRecord& c : m.scene->clusters_of_mesh()) {
            const Vector3d center = m.in_scene({c.center[0], c.center[1], c.center[2]});
            const double size = m.scale * double(c.radius) * (1 + 1e-5);
            if (!((center - nearest_on(line, center)).norm() - size <= reach)) continue;
            for (std::uint32_t t = c.first_triangle; t < c.first_triangle + c.triangles; ++t) {
                auto corner = corners_of(*m.scene, t);
                if (!corner) return;
                for (Vector3d& p : *corner) p = m.in_scene(p);
                const auto& [p, q, r] = *corner;
                const Vector3d on_line = nearest_on(line, (p + q + r) / 3), at = nearest_on(*corner, on_line);
                const NearTriangle found{&m, t, (q - p).cross(r - p) / 2, at, (at - on_line).norm()};
                if (found.distance <= reach && found.area.squaredNorm() > 0) visit(found);
            }
        }
}

/// Whether a triangle's normal points to the side from which a photo sees it; true if no photo sees it.
bool winds_outward(const NearTriangle& t) {
    const PlanScene& scene = *t.mesh->scene;
    const auto seen = smallest_footprint(scene, t.number, t.mesh->in_mesh(t.at));
    return !seen || t.area.dot(t.mesh->in_scene(scene.poses[seen->photo].center()) - t.at) >= 0;
}

/// The sum of the normals of the triangles nearest to a point, such as all those at a vertex. Zero if there
/// are none.
struct Facing {
    Vector3d outward = Vector3d::Zero(), wound = Vector3d::Zero();  ///< according to the photos, and the mesh
};
Facing facing_at(std::span<const PlacedMesh> meshes, const Vector3d& p, double radius) {
    double reach = std::numeric_limits<double>::infinity();
    visit_near(meshes, {p, p}, reach, [&](const NearTriangle& t) { reach = t.distance; });
    Facing out;
    if (!std::isfinite(reach)) return out;
    reach += 1e-5 * radius;
    visit_near(meshes, {p, p}, reach, [&](const NearTriangle& t) {
        const Vector3d normal = t.area.normalized() * std::min(1.0, t.area.norm() / (radius * radius));
        out.wound += normal;
        out.outward += winds_outward(t) ? normal : Vector3d(-normal);
    });
    return out;
}

/// The mean normal of the surface along the line, toward the outside; zero if the surface has none. Parts far
/// from the line and those that face the other side at the ends, such as the back of a wall, are left out.
struct Outward {
    Vector3d normal;
    double winding;  ///< 1, or -1 if the mesh's triangles are clockwise as seen from outside
};
Outward outward_normal(std::span<const PlacedMesh> meshes, const Ends& line) {
    const double radius = near_line * (line[1] - line[0]).norm();
    const Facing a = facing_at(meshes, line[0], radius), b = facing_at(meshes, line[1], radius);
    const Vector3d at_ends = a.outward.stableNormalized() + b.outward.stableNormalized();
    if (!(at_ends.norm() > sine_5)) return {Vector3d::Zero(), 1};
    const double side = at_ends.dot(a.wound + b.wound) < 0 ? -1 : 1;
    Vector3d sum = Vector3d::Zero();
    visit_near(meshes, line, radius, [&](const NearTriangle& t) {
        const double weight = std::min(t.area.norm(), radius * radius) * (1 - t.distance / radius);
        if (side * t.area.dot(at_ends) > 0) sum += side * weight * t.area.normalized();
    });
    return {(sum.squaredNorm() > 0 ? sum : at_ends).stableNormalized(), side};
}

/// The normal, made vertical or horizontal if it nearly is.
Vector3d upright(const Vector3d& normal, const Vector3d& up) {
    const double rise = normal.dot(up);
    const Vector3d level = normal - rise * up;
    if (level.norm() < sine_20 * normal.norm()) return rise > 0 ? up : Vector3d(-up);
    return std::abs(rise) < sine_20 ? Vector3d(level.normalized()) : normal;
}

/// Sets the outermost offsets on a line of the section; `outward`: 1, or -1 if the outside is below.
void add_line(SurfaceProfile& p, const SectionLine& line, double outward, double farthest) {
    std::array<Eigen::Vector2d, 2> end;
    for (std::size_t i = 0; i < 2; ++i)
        end[i] = {p.along.dot(line[i] - p.from), p.across.dot(line[i] - p.from)};
    if (end[0].x() > end[1].x()) std::swap(end[0], end[1]);
    const double width = end[1].x() - end[0].x(), step = p.length / double(profile_steps),
                 rounding = 1e-9 * p.length;  // so that there are no gaps between lines
    if (!(width > 0) || end[1].x() < -rounding || end[0].x() > p.length + rounding) return;
    const auto first = std::size_t(std::max(0.0, std::ceil((end[0].x() - rounding) / step)));
    for (std::size_t i = first; i <= profile_steps && p.distance(i) <= end[1].x() + rounding; ++i) {
        const double s = p.distance(i), share = std::clamp((s - end[0].x()) / width, 0.0, 1.0),
                     offset = end[0].y() + share * (end[1].y() - end[0].y());
        if (!(std::abs(offset - p.rise * s / p.length) <= farthest)) continue;
        auto& known = p.offsets[i];
        if (!known || outward * (offset - *known) > 0) known = offset;
    }
}

SurfaceProfile without(const char* reason) { return {.reason = reason}; }

}  // namespace

std::optional<Vector3d> SurfaceProfile::point(std::size_t i) const {
    if (!offsets[i]) return {};
    return from + distance(i) * along + *offsets[i] * across;
}

SurfaceProfile profile_between(std::span<const PlacedMesh> meshes, std::span<const SectionPlane> sections,
                               const std::array<Vector3d, 2>& points, const Vector3d& up) {
    const Vector3d step = points[1] - points[0];
    const double length = step.stableNorm();
    if (!(length > 0)) return without(marked("no profile: the points are equal"));
    constexpr const char* no_surface = marked("no profile: no surface along the line");
    if (std::ranges::all_of(meshes, [](const PlacedMesh& m) { return m.scene->clusters_of_mesh().empty(); }))
        return without(no_surface);
    const Outward surface = outward_normal(meshes, points);
    const Vector3d normal = upright(surface.normal, up);
    SurfaceProfile out{.from = points[0]};
    out.heights = std::abs(normal.dot(up)) > 1 - 1e-12;
    out.across = out.heights ? up : Vector3d(normal - step * (step.dot(normal) / (length * length)));
    out.along = out.heights ? Vector3d(step - up * up.dot(step)) : step;
    if (!(out.across.norm() > sine_5) || !(out.along.norm() > sine_5 * length))
        return without(marked("no profile: the line does not run along the surface"));
    out.across.normalize();
    out.along.normalize();
    out.length = out.along.dot(step);
    out.rise = out.heights ? out.across.dot(step) : 0;
    out.offsets.resize(profile_steps + 1);
    const Vector3d plane = out.along.cross(out.across);
    const double outward = out.across.dot(normal) < 0 ? -1 : 1;
    SurfaceProfile inward = out;  // of surface that faces inward, such as the back of an object before a wall
    for (const SectionLine& line : lines_in(meshes, {plane, plane.dot(points[0])}, sections)) {
        const double faces = surface.winding * outward * (line[1] - line[0]).cross(plane).dot(out.across);
        add_line(faces < 0 ? inward : out, line, outward, length / 2);
    }
    for (std::size_t i = 0; i < out.offsets.size(); ++i)
        if (!out.offsets[i]) out.offsets[i] = inward.offsets[i];
    const bool found = std::ranges::any_of(out.offsets, [](const auto& o) { return o.has_value(); });
    return found ? out : without(no_surface);
}

std::string profile_csv(const SurfaceProfile& p, const Scale& scale, const Vector3d& origin) {
    constexpr int digits = 12;
    const double factor = shown_length(scale);
    std::string out = "distance,offset,unit,x,y,z\n";
    for (std::size_t i = 0; i < p.offsets.size(); ++i) {
        out += number_text(p.distance(i) * factor, digits, p.length * factor) + ",";
        if (p.offsets[i]) out += number_text(*p.offsets[i] * factor, digits, p.length * factor);
        out += std::string(",") + name_of(shown_unit(scale));
        for (int axis = 0; axis < 3; ++axis) {
            out += ",";
            if (const auto at = p.point(i))
                out += number_text((*at + origin)[axis], digits, (*at + origin).cwiseAbs().maxCoeff());
        }
        out += "\n";
    }
    return out;
}

}  // namespace vantage
