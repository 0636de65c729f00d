#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/background/depth/planes.h"
#include "pipeline/background/view_sample.h"
#include "pipeline/presentation/up_direction.h"

namespace vantage {
namespace {

constexpr float largest = 0.5f;  ///< maximum difference of ln(color), averaged over the channels
constexpr int step = 6;          ///< distance between compared texels, in both directions
constexpr std::size_t max_comparisons = 300'000;
constexpr int heights = 24;
constexpr int max_rounds = 24;

/// The agreement of the photos if their open texels lie on a plane: the sum of `largest` minus the color
/// difference, over all texels whose rays meet the plane and over all other photos.
class PlaneAgreement {
  public:
    explicit PlaneAgreement(std::span<const CoarseView> views) : views_(views) {
        for (const CoarseView& v : views) {
            auto& rays = rays_.emplace_back();
            const Eigen::Matrix3d world = v.pose.R.transpose();
            for (int y = step / 2; y < v.k.height; y += step)
                for (int x = step / 2; x < v.k.width; x += step) {
                    const auto at = std::size_t(y) * std::size_t(v.k.width) + std::size_t(x);
                    if (!v.is_open(at)) continue;
                    const Eigen::Vector3d ray((x + 0.5 - v.k.cx) / v.k.fx, (y + 0.5 - v.k.cy) / v.k.fy, 1);
                    rays.push_back({(world * ray).normalized(), v.ln[at]});
                }
        }
        thin();
    }

    double operator()(const Plane& plane) const {
        double sum = 0;
        for (std::size_t i = 0; i < views_.size(); ++i) {
            const Eigen::Vector3d eye = views_[i].pose.center();
            const double above = plane.height - plane.normal.dot(eye);
            if (!(above > 0)) continue;
            for (const Ray& ray : rays_[i]) {
                const double steepness = plane.normal.dot(ray.direction);
                if (steepness < 1e-3) continue;
                sum += agreement(i, eye + above / steepness * ray.direction, ray.ln);
            }
        }
        return sum;
    }

  private:
    struct Ray {
        Eigen::Vector3d direction;
        Eigen::Array3f ln;
    };
    /// Limits the number of comparisons: a sample of each view's rays is enough to judge a plane.
    void thin() {
        std::size_t count = 0;
        for (const auto& rays : rays_) count += rays.size();
        const std::size_t every = 1 + count * views_.size() / max_comparisons;
        for (auto& rays : rays_) {
            for (std::size_t i = 0; i * every < rays.size(); ++i) rays[i] = rays[i * every];
            rays.resize((rays.size() + every - 1) / every);
        }
    }
    double agreement(std::size_t from, const Eigen::Vector3d& point, const Eigen::Array3f& ln) const {
        double sum = 0;
        for (std::size_t j = 0; j < views_.size(); ++j) {
            if (j == from) continue;
            const Eigen::Vector3f p = (views_[j].pose.R * point + views_[j].pose.t).cast<float>();
            const ViewSample s = sample(views_[j], p, 1);
            if (s.kind == ViewSample::open) sum += std::max(0.0f, largest - (s.ln - ln).abs().mean());
        }
        return sum;
    }

    std::span<const CoarseView> views_;
    std::vector<std::vector<Ray>> rays_;
};

/// Improves a plane by a compass search over its height, and over its tilt unless the tilt is known.
Plane refined(const PlaneAgreement& agreement, Plane plane, double value, double lowest,
              const Eigen::Vector3d& pivot, bool tilt_known) {
    const Eigen::Vector3d a = plane.normal.unitOrthogonal(), b = plane.normal.cross(a);
    const std::array<Eigen::Vector3d, 2> axes{a, b};
    const auto tilted = std::span(axes).first(tilt_known ? 0 : 2);
    double tilt = 0.02, height = 0.1 * (plane.height - lowest);
    for (int round = 0; round < max_rounds && tilt > 1e-3; ++round) {
        bool better = false;
        const auto consider = [&](const Plane& p) {
            const double v = agreement(p);
            if (v > value) value = v, plane = p, better = true;
        };
        for (const double sign : {-1.0, 1.0}) {
            consider({plane.normal, plane.height + sign * height});
            for (const Eigen::Vector3d& axis : tilted) {
                const Eigen::Vector3d normal = (plane.normal + sign * tilt * axis).normalized();
                const Eigen::Vector3d below = pivot + (plane.height - plane.normal.dot(pivot)) * plane.normal;
                consider({normal, normal.dot(below)});
            }
        }
        if (!better) tilt /= 2, height /= 2;
    }
    return plane;
}

}  // namespace

double lowest_camera(std::span<const CoarseView> views, const Eigen::Vector3d& down) {
    double lowest = -std::numeric_limits<double>::infinity();
    for (const CoarseView& v : views) lowest = std::max(lowest, down.dot(v.pose.center()));
    return lowest;
}

Eigen::Vector3d down_direction(std::span<const CoarseView> views) {
    std::vector<Pose> poses;
    for (const CoarseView& v : views) poses.push_back(v.pose);
    return -up_of_cameras(poses).up;
}

Eigen::Vector3d down_direction(std::span<const CoarseView> views, const MeshPlanes& mesh) {
    return mesh.down ? *mesh.down : down_direction(views);
}

std::optional<Plane> find_ground(std::span<const CoarseView> views, const MeshPlanes& mesh) {
    if (views.size() < 2) return std::nullopt;
    const Eigen::Vector3d down = down_direction(views, mesh);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const CoarseView& v : views) mean += v.pose.center() / double(views.size());
    const double lowest = lowest_camera(views, down);
    double spread = 0;
    for (const CoarseView& v : views) spread = std::max(spread, 2 * (v.pose.center() - mean).norm());
    if (!(spread > 0)) return mesh.floor;
    const PlaneAgreement agreement(views);
    std::array<double, heights> values{};
    const auto plane = [&](std::size_t i) {
        return Plane{down, lowest + 0.005 * spread * std::pow(200.0, double(i) / (heights - 1))};
    };
    for (std::size_t i = 0; i < heights; ++i) values[i] = agreement(plane(i));
    const auto best = std::size_t(std::ranges::max_element(values) - values.begin());
    // The mesh's floor below an object on a table is the tabletop, which ends nearby; the photos then agree
    // far better on another plane.
    if (mesh.floor && agreement(*mesh.floor) >= 0.5 * values[best]) return mesh.floor;
    // The peak must be inside the range: at its ends, a ground would be visible to hardly any photo, or to
    // all.
    if (best == 0 || best + 1 == heights || values[best] < 1.2 * std::max(values.front(), values.back()))
        return std::nullopt;
    return refined(agreement, plane(best), values[best], lowest, mean, mesh.down.has_value());
}

}  // namespace vantage
