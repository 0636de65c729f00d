#include "pipeline/mesh/nearest_surface.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "base/text/error.h"
#include "base/values/angle_between.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

/// The point on a triangle, or the cloud point, that is nearest to a given point, and the normal there,
/// weighted by the triangle's angle at the nearest point.
struct Nearest {
    Vector3d point, normal;
};

Nearest on_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& normal) {
    const Vector3d along = b - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0;
    return {a + share * along, normal * std::numbers::pi};
}

/// The nearest point on a triangle: inside the triangle if the point projects there, otherwise on the nearest
/// edge.
Nearest on_triangle(const Vector3d& p, const std::array<Vector3d, 3>& c) {
    const Vector3d area = (c[1] - c[0]).cross(c[2] - c[0]);
    const double area2 = area.squaredNorm();
    const Vector3d normal = area2 > 0 ? Vector3d(area / std::sqrt(area2)) : Vector3d::Zero();
    const auto inside = [&](std::size_t i) { return area.dot((c[(i + 1) % 3] - c[i]).cross(p - c[i])) >= 0; };
    if (area2 > 0 && inside(0) && inside(1) && inside(2))
        return {p - normal * normal.dot(p - c[0]), normal * 2 * std::numbers::pi};
    Nearest best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Nearest n = on_segment(p, c[i], c[(i + 1) % 3], normal);
        const double distance = (p - n.point).squaredNorm();
        if (distance < least) least = distance, best = n;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (best.point == c[i])
            best.normal = normal * angle_between(c[(i + 1) % 3] - c[i], c[(i + 2) % 3] - c[i]);
    return best;
}

}  // namespace

struct NearestSurface::State {
    explicit State(const Mesh& mesh) : mesh_(mesh), origin_(mesh.positions.front()) {
        device_ = rtcNewDevice(nullptr);
        if (!device_) throw std::runtime_error("Embree cannot create a device");
        scene_ = rtcNewScene(device_);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(
            geometry, unsigned(mesh.points_only() ? mesh.positions.size() : mesh.triangles.size()));
        rtcSetGeometryUserData(geometry, this);
        rtcSetGeometryBoundsFunction(geometry, write_box, this);
        rtcSetGeometryPointQueryFunction(geometry, visit);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) {
            release();
            throw Error(Exit::memory, "not enough memory for Embree to hold the reference");
        }
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { release(); }

    NearestPoint nearest(const Vector3d& at) const {
        Query query{*this, at};
        RTCPointQuery ball{};
        const Eigen::Vector3f center = (at - origin_).cast<float>();
        query.rounding = (center.cast<double>() - (at - origin_)).norm();
        ball.x = center.x(), ball.y = center.y(), ball.z = center.z();
        ball.radius = std::numeric_limits<float>::infinity();
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(scene_, &ball, &context, nullptr, &query);
        return {query.point, query.normal, query.distance};
    }

    /// The nearest point so far. The normals of all triangles that meet at this point are summed.
    struct Query {
        const State& surface;
        Vector3d at, point = Vector3d::Zero(), normal = Vector3d::Zero();
        double distance = std::numeric_limits<double>::infinity();
        double rounding = 0;  ///< rounding error of the center of Embree's query

        double tolerance() const { return 1e-9 * (distance + (at - surface.origin_).norm()); }
        void consider(const Nearest& n) {
            const double d = (at - n.point).norm();
            if (std::isfinite(distance) && std::abs(d - distance) <= tolerance() &&
                (n.point - point).norm() <= 2 * tolerance()) {
                normal += n.normal;
                distance = std::min(distance, d);
            } else if (d < distance) {
                distance = d, point = n.point, normal = n.normal;
            }
        }
    };

    Nearest on_primitive(const Vector3d& at, unsigned primitive) const {
        if (mesh_.points_only())
            return {mesh_.positions[primitive], mesh_.normals.empty()
                                                    ? Vector3d::Zero()
                                                    : Vector3d(mesh_.normals[primitive].cast<double>())};
        const auto& t = mesh_.triangles[primitive];
        return on_triangle(at, {mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]});
    }

    static bool visit(RTCPointQueryFunctionArguments* args) {
        Query& query = *static_cast<Query*>(args->userPtr);
        query.consider(query.surface.on_primitive(query.at, args->primID));
        // Rounding to single precision must not exclude equally near triangles.
        const double reach = (query.distance + query.tolerance() + query.rounding) * (1 + 1e-6);
        const auto radius = float(std::min(reach, 3e38));
        if (!(radius < args->query->radius)) return false;
        args->query->radius = radius;
        return true;
    }

    static void write_box(const RTCBoundsFunctionArguments* args) {
        const State& s = *static_cast<const State*>(args->geometryUserPtr);
        Eigen::AlignedBox3d box;
        if (s.mesh_.points_only())
            box.extend(s.mesh_.positions[args->primID]);
        else
            for (const std::uint32_t v : s.mesh_.triangles[args->primID]) box.extend(s.mesh_.positions[v]);
        constexpr float most = std::numeric_limits<float>::max();
        const auto below = [&](double x) { return std::nextafter(float(x), -most); };
        const auto above = [&](double x) { return std::nextafter(float(x), most); };
        const Vector3d low = box.min() - s.origin_, high = box.max() - s.origin_;
        RTCBounds& out = *args->bounds_o;
        out.lower_x = below(low.x()), out.lower_y = below(low.y()), out.lower_z = below(low.z());
        out.upper_x = above(high.x()), out.upper_y = above(high.y()), out.upper_z = above(high.z());
    }

    void release() {
        if (scene_) rtcReleaseScene(scene_);
        if (device_) rtcReleaseDevice(device_);
    }

    const Mesh& mesh_;
    Vector3d origin_;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
};

NearestSurface::NearestSurface(const Mesh& mesh) : state_(std::make_unique<State>(mesh)) {}
NearestSurface::~NearestSurface() = default;
NearestSurface::NearestSurface(NearestSurface&&) noexcept = default;

NearestPoint NearestSurface::nearest(const Vector3d& at) const { return state_->nearest(at); }

}  // namespace vantage
