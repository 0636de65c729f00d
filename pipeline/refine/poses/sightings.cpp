#include "pipeline/refine/poses/sightings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/values/angle_between.h"
#include "scene/agreement/color_fit.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

using Eigen::Vector3f;

/// Another photo, with its camera relative to that of the target.
struct Projector {
    const CoarsePhoto& photo;
    std::uint32_t index;
    Eigen::Matrix3f R;
    Vector3f t, center;  ///< the center in the target's camera space
    float fx, fy, cx, cy;
    float radius_scale;  ///< factor from squared texels to the squared vignetting radius
    float focal;         ///< focal length relative to that of the target

    Projector(const OtherPhoto& other, const CoarsePhoto& target, const Pose& pose)
        : photo(*other.photo),
          index(other.index),
          fx(float(photo.k.fx)),
          fy(float(photo.k.fy)),
          cx(float(photo.k.cx)),
          cy(float(photo.k.cy)),
          radius_scale(float(std::pow(vignetting_radius(photo.k, {photo.k.cx + 1, photo.k.cy}), 2))),
          focal(float(photo.focal / target.focal)) {
        const Eigen::Matrix3d turn = other.pose.R * pose.R.transpose();
        const Eigen::Vector3d shift = other.pose.t - turn * pose.t;
        R = turn.cast<float>();
        t = shift.cast<float>();
        center = (-turn.transpose() * shift).cast<float>();
    }
};

/// A surface point in the target's camera space, its unit normal toward the camera, and its unit direction to
/// the camera.
struct Point {
    Vector3f at, normal, to_viewer;
};

/// The four texels around a position; (u, v) is the position between the first and the last texel.
struct Corners {
    const CoarsePhoto::Texel* texel[4];
    float u, v;
};

Corners corners_at(const CoarsePhoto& photo, float x, float y) {
    const auto grid = photo.grid();
    const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
    const int x0 = std::clamp(int(left), 0, grid.width - 1),
              x1 = std::clamp(int(left) + 1, 0, grid.width - 1),
              y0 = std::clamp(int(top), 0, grid.height - 1),
              y1 = std::clamp(int(top) + 1, 0, grid.height - 1);
    return {{&grid(x0, y0), &grid(x1, y0), &grid(x0, y1), &grid(x1, y1)}, x - 0.5f - left, y - 0.5f - top};
}

/// Corresponds to seen() in blend.frag.
float visibility(const Projector& p, const Corners& c, const Vector3f& at, const Vector3f& normal) {
    const float cosine = std::max(std::abs(normal.dot(at)) / at.norm(), shader::least_cosine),
                slack = std::max(shader::depth_slack * at.z(), at.z() / std::min(p.fx, p.fy) / cosine);
    const auto [nearest, farthest] =
        std::minmax({c.texel[0]->z, c.texel[1]->z, c.texel[2]->z, c.texel[3]->z});
    if (at.z() > farthest + slack || !(farthest > 0)) return 0;
    return at.z() > nearest + slack ? shader::beside : 1;
}

/// Corresponds to angle_weight() times own_view() in blend.frag.
float angle_weight(float theta) {
    const float near = shader::own_angle / std::max(theta, shader::own_least);
    return std::max(std::exp(-theta / shader::default_sharpness), 1e-12f) * (1 + near * near);
}

/// Returns false if the photo does not show the point.
bool sighting(const Projector& p, const Point& point, Sighting& out) {
    const Vector3f to_photo = p.center - point.at;
    if (point.normal.dot(to_photo) < 0) return false;
    const Vector3f at = p.R * point.at + p.t;
    if (!(at.z() > 0)) return false;
    out.x = p.fx * at.x() / at.z() + p.cx;
    out.y = p.fy * at.y() / at.z() + p.cy;
    if (!(out.x >= 0 && out.y >= 0 && out.x < float(p.photo.k.width) && out.y < float(p.photo.k.height)))
        return false;
    const Corners c = corners_at(p.photo, out.x, out.y);
    const float seen = visibility(p, c, at, p.R * point.normal);
    if (!(seen > 0)) return false;
    const float share[4] = {(1 - c.u) * (1 - c.v), c.u * (1 - c.v), (1 - c.u) * c.v, c.u * c.v};
    out.weight = 0;
    for (std::size_t i = 0; i < 4; ++i) out.weight += share[i] * c.texel[i]->weight;
    const Eigen::Array4f linear = p.photo.means.around(out.x, out.y);
    if (!std::isfinite(linear[0])) return false;
    const float* smooth = p.photo.grid()(int(out.x), int(out.y)).smooth;
    if (!std::isfinite(smooth[0])) smooth = linear.data();
    for (std::size_t i = 0; i < 3; ++i) {
        out.root[i] = std::sqrt(linear[Eigen::Index(i)]);
        out.smooth[i] = std::sqrt(smooth[i]);
    }
    out.photo = p.index;
    const float right = out.x - p.cx, down = out.y - p.cy;
    out.radius2 = (right * right + down * down) * p.radius_scale;
    out.theta = angle_between(point.to_viewer, to_photo);
    // Corresponds to sampling() in blend.frag for a view of the target's size, but ignores the slant.
    const float sampling = std::clamp(p.focal * point.at.z() / at.z(), 0.001f, 1.0f);
    out.weight *= seen * angle_weight(out.theta) * sampling;
    return true;
}

/// The target's pixels as points on the surface.
class Surface {
  public:
    explicit Surface(const CoarsePhoto& target) : target_(target) {}

    /// Returns false where the target does not see the model.
    bool point(int x, int y, Point& out) const {
        if (!std::isfinite(target_.grid()(x, y).z)) return false;
        out.at = at(x, y);
        const Vector3f along = difference(x, y, 1, 0), down = difference(x, y, 0, 1);
        out.normal = along.cross(down);
        if (out.normal.dot(out.at) > 0) out.normal = -out.normal;
        out.to_viewer = -out.at.normalized();
        const float length = out.normal.norm();
        out.normal = length > 0 ? Vector3f(out.normal / length) : out.to_viewer;
        return true;
    }

  private:
    Vector3f at(int x, int y) const {
        const float z = target_.grid()(x, y).z;
        return {(float(x) + 0.5f - float(target_.k.cx)) / float(target_.k.fx) * z,
                (float(y) + 0.5f - float(target_.k.cy)) / float(target_.k.fy) * z, z};
    }

    /// The difference from the neighbor with the more similar depth, so that a normal at an edge is that of a
    /// single surface.
    Vector3f difference(int x, int y, int dx, int dy) const {
        const auto z = [&](int i, int j) {
            const bool inside = i >= 0 && j >= 0 && i < target_.k.width && j < target_.k.height;
            return inside ? target_.grid()(i, j).z : std::numeric_limits<float>::infinity();
        };
        const float here = z(x, y), after = std::abs(z(x + dx, y + dy) - here),
                    before = std::abs(z(x - dx, y - dy) - here);
        if (!std::isfinite(std::min(after, before))) return Vector3f::Zero();
        return after <= before ? at(x + dx, y + dy) - at(x, y) : at(x, y) - at(x - dx, y - dy);
    }

    const CoarsePhoto& target_;
};

}  // namespace

Sightings sightings(const CoarsePhoto& target, std::span<const OtherPhoto> others) {
    return sightings(target, target.pose, others);
}

Sightings sightings(const CoarsePhoto& target, const Pose& pose, std::span<const OtherPhoto> others) {
    std::vector<Projector> projectors;
    for (const OtherPhoto& o : others) projectors.emplace_back(o, target, pose);
    const Surface surface(target);
    Sightings out;
    out.first.reserve(target.texels.size() + 1);
    out.all.reserve(target.texels.size() * others.size() / 2);
    out.first.push_back(0);
    for (int y = 0; y < target.k.height; ++y)
        for (int x = 0; x < target.k.width; ++x) {
            Point point;
            Sighting s;
            if (surface.point(x, y, point))
                for (const Projector& p : projectors)
                    if (sighting(p, point, s)) out.all.push_back(s);
            out.first.push_back(std::uint32_t(out.all.size()));
        }
    return out;
}

}  // namespace vantage
