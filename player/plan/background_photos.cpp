#include "player/plan/background_photos.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "player/plan/own_photo.h"
#include "player/plan/selection/photo_cover.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

/// The weight of a photo near its own camera, relative to `label_weight` (shaders/background.frag).
double own_weight(const PlanScene& s, double apart) {
    const double r = shader::own_angle * 2 * s.spread / std::max(apart, 1e-30);
    return std::min(r * r, 1e6);
}

/// The visible triangles of the background, with repetitions.
std::vector<std::uint32_t> triangles_behind(const VisibleSurface& s) {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t t : s.triangles)
        if (t >= s.scene.first_triangle_behind()) out.push_back(t);
    return out;
}

/// Whether a triangle of a background cluster has the photo's label.
bool has_label(const PlanScene& scene, std::uint32_t photo, const package::ClusterRecord& c) {
    const std::size_t words = package::visible_words(scene.triangles);
    return count_bits(scene.visible[photo].subspan(words, words), c.first_triangle, c.triangles) > 0;
}

/// Whether a photo's labels cover more than this fraction of the frame. `behind`: see triangles_behind.
bool paints(const VisibleSurface& s, std::span<const std::uint32_t> behind, std::uint32_t photo,
            double least) {
    if (s.scene.labels[photo] == 0) return false;
    if (s.triangles.empty())
        return std::ranges::any_of(s.clusters, [&](std::uint32_t index) {
            return index >= s.scene.first_surrounding && has_label(s.scene, photo, s.scene.clusters[index]);
        });
    const auto shown =
        std::ranges::count_if(behind, [&](std::uint32_t t) { return sees(s.scene, photo, t); });
    return double(shown) > least * double(s.triangles.size());
}

}  // namespace

void find_nearest_shares(const PlanScene& s, const Eigen::Vector3d& eye, std::vector<float>& shares) {
    // The nearest photos, nearest first: one more than the number of photos with a nonzero weight.
    struct Near {
        std::size_t photo;
        double nearness;
    };
    std::array<Near, shader::nearest_photos + 1> near{};
    for (std::size_t i = 0; i < s.photos.size(); ++i) {
        if (s.photos[i].image_set != 0 || !s.photos[i].levels) continue;
        Near next{i, 1 / std::max((s.poses[i].center() - eye).norm(), 1e-9 * s.size)};
        for (Near& n : near)
            if (next.nearness > n.nearness) std::swap(next, n);
    }
    const double least = near.back().nearness;
    double sum = 0;
    for (const Near& n : near) sum += n.nearness - least;
    shares.assign(s.photos.size(), 0);
    for (const Near& n : near)
        if (sum > 0 && n.nearness > least) shares[n.photo] = float((n.nearness - least) / sum);
}

double near_distance(const PlanScene& s, const Eigen::Vector3d& eye) {
    const bool own = own_weight(s, distance_from_cameras(s, eye)) > shader::negligible * shader::label_weight;
    return own ? std::numeric_limits<double>::infinity() : shader::near_reach * s.spread;
}

std::vector<PlannedPhoto> plan_background(const VisibleSurface& s, const PlanSettings& settings,
                                          std::span<const std::uint32_t> allowed) {
    std::vector<PlannedPhoto> out;
    if (!s.scene.has_background() || !settings.background) return out;
    constexpr float least = 0.01f;
    constexpr std::uint32_t none = ~0u;
    std::vector<float> shares;
    find_nearest_shares(s.scene, s.eye, shares);
    const std::vector<std::uint32_t> behind = triangles_behind(s);
    const double reach = near_distance(s.scene, s.eye);
    std::uint32_t own = own_photo(s.scene, s.view, allowed).value_or(none);
    if (own != none && s.scene.photos[own].image_set != 0) own = none;  // others show no background
    for (const std::uint32_t photo : allowed) {
        if (s.scene.coverage[photo].empty() || (own != none && photo != own)) continue;
        const float share = shares[photo];
        if (share < least && !paints(s, behind, photo, settings.complete ? 0 : 0.001)) continue;
        PlannedPhoto p{photo, share, {}, {}, {}};
        for (const std::uint32_t c : s.clusters)
            if (c >= s.scene.first_surrounding && s.scene.coverage[photo][c].seen > 0 &&
                (share >= least || has_label(s.scene, photo, s.scene.clusters[c])))
                p.clusters.push_back(c);
        const auto weight = [&](std::size_t i) {
            if (s.points.clusters[i] < s.scene.first_surrounding) return 0.0f;
            if (sees(s.scene, photo, s.points.triangles[i])) return 1.0f;
            return (s.points.samples[i].position - s.eye).norm() < reach ? share : 0.0f;
        };
        const double margin = std::log2(double(shader::background_margin) * s.scene.photos[photo].width /
                                        double(shader::reference_width));
        if (settings.tiles) add_needs(p, s, settings, weight, margin);
        if (!p.clusters.empty()) out.push_back(std::move(p));
    }
    return out;
}

}  // namespace vantage
