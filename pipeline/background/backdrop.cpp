#include "pipeline/background/backdrop.h"

#include <algorithm>
#include <cmath>

#include "pipeline/background/depth/depth_smoothing.h"
#include "pipeline/background/depth/refine_depths.h"
#include "pipeline/background/depth/walls_beyond.h"
#include "pipeline/background/view_sample.h"

namespace vantage {
namespace {

/// A rotation to the cameras' own axes, so that the world's do not matter.
Eigen::Matrix3f frame_of(std::span<const CoarseView> views) {
    const Eigen::Vector3d down = down_direction(views);
    Eigen::Vector3d forward = Eigen::Vector3d::Zero();
    for (const CoarseView& v : views) forward += v.pose.direction();
    forward -= forward.dot(down) * down;
    if (forward.norm() < 1e-3 * double(views.size())) forward = views[0].pose.R.row(0).transpose();
    const Eigen::Vector3d right = down.cross(forward).normalized();
    Eigen::Matrix3f out;
    out << right.cast<float>(), down.cross(right).cast<float>(), down.cast<float>();
    return out;
}

/// Directions of the sky become infinitely far.
void move_sky_away(Backdrop& backdrop, std::span<const CoarseView> views, const SweptDepths& depths,
                   std::vector<float>& inverse, unsigned threads) {
    backdrop.is_sky = sky_directions(views, backdrop.sky, backdrop.sphere, threads);
    const std::vector<float> base = base_depths(backdrop.sphere, depths.center, depths.reach, {});
    for (std::size_t v = 0; v < backdrop.is_sky.size(); ++v)
        if (backdrop.is_sky[v]) inverse[v] = base[v];
}

/// What a direction shows, for colors that are continued.
enum class Side { sky, above, below };
Side side_of(const Backdrop& b, std::size_t direction) {
    if (b.is_sky[direction]) return Side::sky;
    return b.sphere.directions[direction].dot(b.sky.down) < 0 ? Side::above : Side::below;
}

/// The median color of a direction, square root of light, with weight 1; of the sky, among the views that
/// show sky.
Eigen::Array4f median_color(const Backdrop& b, std::span<const CoarseView> views, std::size_t direction) {
    thread_local std::vector<Eigen::Array3f> colors;
    colors.clear();
    for (std::size_t i = 0; i < views.size(); ++i) {
        const CoarseView& v = views[i];
        const ViewSample s = sample(v, in_camera(v, b.positions[direction]), 1);
        if (s.kind != ViewSample::open || (b.is_sky[direction] && !b.sky.at(i, v, s))) continue;
        colors.push_back(root_of(s.ln));
    }
    Eigen::Array4f out = Eigen::Array4f::Zero();
    if (!colors.empty()) out << median(colors), 1;
    return out;
}

/// Sums of colors, square roots of light, and their weights.
using ColorSums = std::vector<Eigen::Array4f>;

/// Colors of weight 1 in all directions: means over ever larger neighborhoods where none is known (pull-push,
/// Gortler et al. 1996). Each sphere is that before it, divided.
ColorSums continued(std::span<const DirectionSphere> spheres, ColorSums known) {
    std::vector<ColorSums> levels{std::move(known)};
    for (std::size_t l = spheres.size() - 1; l-- > 0;) {
        ColorSums coarse(spheres[l].directions.size());
        for (std::size_t v = 0; v < coarse.size(); ++v) {
            coarse[v] = 2 * levels.back()[v];
            for (const std::uint32_t u : spheres[l + 1].neighbors[v])
                if (u != DirectionSphere::none) coarse[v] += levels.back()[u];
            coarse[v] /= std::max(coarse[v][3], 1.0f);
        }
        levels.push_back(std::move(coarse));
    }
    Eigen::Array4f all = Eigen::Array4f::Zero();
    for (const Eigen::Array4f& c : levels.back()) all += c;
    all = all[3] > 0 ? Eigen::Array4f(all / all[3]) : Eigen::Array4f(0.5f, 0.5f, 0.5f, 1);
    for (Eigen::Array4f& c : levels.back()) c += (1 - std::min(c[3], 1.0f)) * all;
    for (std::size_t l = 1; l < spheres.size(); ++l) {
        const ColorSums coarse = std::move(levels.back());
        levels.pop_back();
        ColorSums& here = levels.back();
        for (std::size_t v = 0; v < here.size(); ++v) {
            const float lacks = 1 - std::min(here[v][3], 1.0f);
            if (!(lacks > 0)) continue;
            const auto [a, b] = spheres[l].ends[v];
            here[v] += lacks * (v < coarse.size() ? coarse[v] : Eigen::Array4f((coarse[a] + coarse[b]) / 2));
        }
    }
    return std::move(levels.back());
}

}  // namespace

bool have_parallax(std::span<const CoarseView> views) {
    double farthest = 0, size = 0;
    for (const CoarseView& v : views) {
        farthest = std::max(farthest, (v.pose.center() - views[0].pose.center()).norm());
        size = std::max(size, v.pose.center().norm());
    }
    return views.size() > 1 && farthest > 1e-6 * size;
}

Backdrop estimate_backdrop(std::span<const CoarseView> views, const MeshPlanes& mesh,
                           const BackdropDetail& detail, unsigned threads) {
    Backdrop out{
        .sphere = direction_sphere(detail.sphere), .center = {}, .positions = {}, .sky = {}, .is_sky = {}};
    const Eigen::Matrix3f frame = frame_of(views);
    for (Eigen::Vector3f& d : out.sphere.directions) d = (frame * d).normalized();
    ScenePlanes planes{find_ground(views, mesh), mesh.largest};
    SweptDepths depths = sweep_depths(views, out.sphere, planes, detail.labels, threads);
    out.center = depths.center;
    std::vector<float> inverse = inverse_distances(depths, out.sphere);
    const Eigen::Vector3d down = down_direction(views, mesh);
    const std::vector<Plane> beyond = walls_beyond(depths, out.sphere, inverse, down);
    if (!beyond.empty()) {
        prefer_planes(depths, views, out.sphere, beyond, threads);
        planes.walls.insert(planes.walls.end(), beyond.begin(), beyond.end());
        inverse = inverse_distances(depths, out.sphere);
    }
    out.sky.down = down.cast<float>();
    if (detail.sky) out.sky = find_sky(views, depths, out.sphere, inverse, down);
    move_sky_away(out, views, depths, inverse, threads);
    for (int l = 0; l < detail.refinements; ++l) {
        DirectionSphere fine = divided(out.sphere);
        inverse = refine_depths(views, planes, depths, inverse, fine, threads);
        out.sphere = std::move(fine);
    }
    move_sky_away(out, views, depths, inverse, threads);
    for (std::size_t v = 0; v < inverse.size(); ++v)
        out.positions.push_back(
            (out.center + out.sphere.directions[v].cast<double>() / double(inverse[v])).cast<float>());
    return out;
}

std::vector<Eigen::Array3f> calm_colors(const Backdrop& backdrop, std::span<const CoarseView> views) {
    constexpr int fine_level = 5;  // directions: colors are smooth
    constexpr int smoothing = 3;   // rounds
    std::vector<DirectionSphere> spheres;
    for (int l = 0;
         l <= fine_level && (l == 0 || spheres.back().directions.size() < backdrop.positions.size()); ++l)
        spheres.push_back(l == 0 ? direction_sphere(0) : divided(spheres.back()));
    const DirectionSphere& fine = spheres.back();
    const std::size_t n = fine.directions.size();
    ColorSums shown(n);
    for (std::size_t v = 0; v < n; ++v) shown[v] = median_color(backdrop, views, v);
    std::vector<Eigen::Array3f> out(n);
    for (const Side side : {Side::sky, Side::above, Side::below}) {
        ColorSums known = shown;
        for (std::size_t v = 0; v < n; ++v)
            if (side_of(backdrop, v) != side) known[v].setZero();
        if (std::ranges::all_of(known, [](const Eigen::Array4f& c) { return c[3] == 0; })) known = shown;
        known = continued(spheres, std::move(known));
        for (std::size_t v = 0; v < n; ++v)
            if (side_of(backdrop, v) == side) out[v] = known[v].head<3>();
    }
    relax(fine, std::vector<std::uint8_t>(n, 1), smoothing, out);
    out.reserve(backdrop.positions.size());
    for (std::size_t v = n; v < backdrop.positions.size(); ++v) {
        const auto [a, b] = backdrop.sphere.ends[v];
        out.push_back((out[a] + out[b]) / 2);
    }
    for (Eigen::Array3f& c : out) c = c.square();
    return out;
}

}  // namespace vantage
