#include "pipeline/surroundings/depth_sweep.h"

#include <algorithm>
#include <cmath>

#include "pipeline/run/for_each_photo.h"
#include "pipeline/surroundings/view_sample.h"

namespace vantage {
namespace {

constexpr float nearest = 1.0f;          ///< the largest inverse distance over the base, times the reach
constexpr float infinite = 1.0f / 4096;  ///< an inverse distance, times the reach, that counts as infinity
// Costs, in the unit of ln(color).
constexpr float largest = 0.5f;  ///< of one photo's difference from the others
constexpr float shown_once = 0.35f, shown_never = 0.4f;
constexpr float hides = 1.0f;   ///< the place would hide the mesh
constexpr float inside = 2.0f;  ///< a camera would be behind it
constexpr float nearer = 0.2f;  ///< added toward the nearest label: without evidence, the base
constexpr float not_base = 0.02f;
constexpr float on_a_plane = 0.04f;  ///< subtracted on planes of the mesh
constexpr std::size_t run = 256;     ///< directions per task

struct Cameras {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    double reach = 0;
};
Cameras cameras_of(std::span<const CoarseView> views) {
    Cameras c;
    for (const CoarseView& v : views) c.center += v.pose.center() / double(views.size());
    for (const CoarseView& v : views)
        c.reach += (v.pose.center() - c.center).squaredNorm() / double(views.size());
    c.reach = std::sqrt(c.reach);
    return c;
}

/// A photo, and how places on a direction get into its camera space.
struct SweptView {
    const CoarseView& view;
    Eigen::Matrix3f R;
    Eigen::Vector3f center;  ///< the sweep's, in camera space
};

/// The cost of a place from its colors: mean difference from the median.
float disagreement(const std::vector<Eigen::Array3f>& colors) {
    if (colors.empty()) return shown_never;
    if (colors.size() == 1) return shown_once;
    const Eigen::Array3f middle = median(colors);
    float sum = 0;
    for (const auto& color : colors) sum += std::min(largest, (color - middle).abs().mean());
    return sum / float(colors.size() - 1);
}

class Sweep {
  public:
    Sweep(std::span<const CoarseView> views, SweptDepths& depths, const DirectionSphere& sphere)
        : depths_(depths), sphere_(sphere) {
        for (const CoarseView& v : views)
            views_.push_back(
                {v, v.pose.R.cast<float>(), (v.pose.R * depths.center + v.pose.t).cast<float>()});
        for (const CoarseView& v : views) eyes_.push_back((v.pose.center() - depths.center).cast<float>());
    }

    /// Cameras must stay inside.
    float innermost(std::uint32_t direction) const {
        float most = std::numeric_limits<float>::infinity();
        for (const Eigen::Vector3f& eye : eyes_) {
            const float distance = eye.norm();
            if (sphere_.directions[direction].dot(eye) > 0.98f * distance)
                most = std::min(most, 1 / (1.05f * std::max(distance, 1e-30f)));
        }
        return most;
    }

    /// Whether a photo may show this direction at some depth.
    bool is_shown(std::uint32_t direction) const {
        for (int label = 0; label < depths_.labels; label += 8) {
            const float inverse = inverse_of(direction, label);
            for (const SweptView& v : views_) {
                const Eigen::Vector3f p = v.center * inverse + v.R * sphere_.directions[direction];
                if (sample(v.view, p, inverse).kind != ViewSample::nothing) return true;
            }
        }
        return false;
    }

    /// The cost of each label.
    void costs(std::uint32_t direction, float* cost) const {
        std::vector<Eigen::Array3f> colors;
        const float most = depths_.most[direction];
        for (int label = 0; label < depths_.labels; ++label)
            cost[label] = this->cost(direction, inverse_of(direction, label), most, colors);
    }
    /// That of one place.
    float cost(std::uint32_t direction, float inverse) const {
        std::vector<Eigen::Array3f> colors;
        return cost(direction, inverse, depths_.most[direction], colors);
    }

  private:
    float cost(std::uint32_t direction, float inverse, float most,
               std::vector<Eigen::Array3f>& colors) const {
        colors.clear();
        bool hiding = false;
        for (const SweptView& v : views_) {
            const ViewSample s =
                sample(v.view, v.center * inverse + v.R * sphere_.directions[direction], inverse);
            hiding |= s.kind == ViewSample::in_front;
            if (s.kind == ViewSample::open) colors.push_back(s.ln);
        }
        return disagreement(colors) + (hiding ? hides : 0) + (inverse > most ? inside : 0);
    }
    float inverse_of(std::uint32_t direction, int label) const {
        return depths_.base[direction] + float(label) * depths_.step;
    }
    const SweptDepths& depths_;
    const DirectionSphere& sphere_;
    std::vector<SweptView> views_;
    std::vector<Eigen::Vector3f> eyes_;  ///< relative to the center
};

std::vector<float> base_depths(const DirectionSphere& sphere, const SweptDepths& d,
                               const std::optional<Plane>& ground) {
    std::vector<float> base(sphere.directions.size(), infinite / float(d.reach));
    if (!ground) return base;
    const double above = ground->height - ground->normal.dot(d.center);
    for (std::size_t v = 0; v < base.size() && above > 0; ++v)
        base[v] = std::max(base[v], float(ground->normal.dot(sphere.directions[v].cast<double>()) / above));
    return base;
}

/// The mean over each direction and its neighbors, which share a photo's noise less than its content.
void average(SweptDepths& d, const DirectionSphere& sphere) {
    const std::vector<std::uint32_t> at = positions_of(d);
    const auto n = std::size_t(d.labels);
    std::vector<float> out(d.cost.size());
    for (std::size_t i = 0; i < d.shown.size(); ++i) {
        float* sum = &out[i * n];
        float weights = 2;
        for (std::size_t l = 0; l < n; ++l) sum[l] = 2 * d.cost[i * n + l];
        for (const std::uint32_t u : sphere.neighbors[d.shown[i]]) {
            if (u == DirectionSphere::none || at[u] == DirectionSphere::none) continue;
            for (std::size_t l = 0; l < n; ++l) sum[l] += d.cost[at[u] * n + l];
            ++weights;
        }
        for (std::size_t l = 0; l < n; ++l) sum[l] /= weights;
    }
    d.cost = std::move(out);
}

/// The inverse distance of a plane in each shown direction; 0 where it is not among the labels.
std::vector<float> plane_depths(const SweptDepths& d, const DirectionSphere& sphere, const Plane& plane) {
    const double above = plane.height - plane.normal.dot(d.center);
    std::vector<float> out;
    for (const std::uint32_t v : d.shown) {
        const double w = plane.normal.dot(sphere.directions[v].cast<double>()) / above;
        const bool labelled = w > d.base[v] && w < double(d.base[v] + d.step * float(d.labels - 1));
        out.push_back(std::isfinite(w) && labelled ? float(w) : 0);
    }
    return out;
}

/// Lowers the cost of the labels next to a plane to that of the plane itself, and a little further, because
/// walls and floors go on beyond the mesh.
void prefer_plane(SweptDepths& d, const DirectionSphere& sphere, const Sweep& sweep,
                  const std::vector<float>& plane, unsigned threads) {
    SweptDepths on_plane;
    on_plane.labels = 1;
    on_plane.base = d.base;
    on_plane.shown = d.shown;
    on_plane.cost.assign(d.shown.size(), largest);
    for_each_photo((d.shown.size() + run - 1) / run, threads, [&](std::size_t r) {
        for (std::size_t i = r * run; i < std::min(d.shown.size(), (r + 1) * run); ++i)
            if (plane[i] > 0) on_plane.cost[i] = sweep.cost(d.shown[i], plane[i]);
    });
    average(on_plane, sphere);
    average(on_plane, sphere);
    for (std::size_t i = 0; i < d.shown.size(); ++i) {
        if (!(plane[i] > 0)) continue;
        const auto label = std::size_t(std::lround((plane[i] - d.base[d.shown[i]]) / d.step));
        float& cost = d.cost[i * std::size_t(d.labels) + label];
        cost = std::min(cost, on_plane.cost[i]) - on_a_plane;
    }
}

}  // namespace

std::vector<std::uint32_t> positions_of(const SweptDepths& d) {
    std::vector<std::uint32_t> out(d.base.size(), DirectionSphere::none);
    for (std::uint32_t i = 0; i < d.shown.size(); ++i) out[d.shown[i]] = i;
    return out;
}

SweptDepths sweep_depths(std::span<const CoarseView> views, const DirectionSphere& sphere,
                         const ScenePlanes& planes, int labels, unsigned threads) {
    const Cameras cameras = cameras_of(views);
    SweptDepths d;
    d.center = cameras.center;
    d.reach = cameras.reach;
    d.labels = labels;
    d.step = nearest / float(d.reach) / float(labels - 1);
    d.base = base_depths(sphere, d, planes.ground);
    const Sweep sweep(views, d, sphere);
    for (std::uint32_t v = 0; v < sphere.directions.size(); ++v) d.most.push_back(sweep.innermost(v));
    const std::size_t n = sphere.directions.size();
    std::vector<std::uint8_t> shown(n, 0);
    for_each_photo((n + run - 1) / run, threads, [&](std::size_t r) {
        for (std::size_t v = r * run; v < std::min(n, (r + 1) * run); ++v)
            shown[v] = sweep.is_shown(std::uint32_t(v));
    });
    for (std::uint32_t v = 0; v < n; ++v)
        if (shown[v]) d.shown.push_back(v);
    d.cost.resize(d.shown.size() * std::size_t(labels));
    for_each_photo((d.shown.size() + run - 1) / run, threads, [&](std::size_t r) {
        for (std::size_t i = r * run; i < std::min(d.shown.size(), (r + 1) * run); ++i)
            sweep.costs(d.shown[i], &d.cost[i * std::size_t(labels)]);
    });
    average(d, sphere);
    average(d, sphere);
    for (const Plane& plane : planes.of_mesh) {
        d.planes.push_back(plane_depths(d, sphere, plane));
        prefer_plane(d, sphere, sweep, d.planes.back(), threads);
    }
    for (std::size_t i = 0; i < d.shown.size(); ++i)
        for (int l = 1; l < labels; ++l)
            d.cost[i * std::size_t(labels) + std::size_t(l)] += not_base + nearer * float(l) / float(labels);
    return d;
}

}  // namespace vantage
