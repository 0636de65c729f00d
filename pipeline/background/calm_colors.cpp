#include "pipeline/background/calm_colors.h"

#include <algorithm>
#include <array>

#include "pipeline/background/view_sample.h"

namespace vantage {
namespace {

/// The class of a direction; colors are extrapolated within a class.
enum class Side { sky, above, below };
Side side_of(const Backdrop& b, std::size_t direction) {
    if (b.is_sky[direction]) return Side::sky;
    return b.sphere.directions[direction].dot(b.sky.down) < 0 ? Side::above : Side::below;
}

/// The color of a direction in its photo, as the square root of light, with weight 1. The weight is 0 if
/// there is no such color or if something occludes the sky.
Eigen::Array4f shown_color(const Backdrop& b, std::span<const CoarseView> views, const BackdropPaint& paint,
                           std::size_t direction) {
    Eigen::Array4f out = Eigen::Array4f::Zero();
    if (paint.view[direction] == BackdropPaint::none) return out;
    const CoarseView& v = views[paint.view[direction]];
    const ViewSample s = sample(v, in_camera(v, b.positions[direction]), 1);
    const bool before_sky =
        b.is_sky[direction] && s.kind == ViewSample::open && !b.sky.at(paint.view[direction], v, s);
    if (s.kind == ViewSample::open && !before_sky)
        out << (root_of(s.ln) + paint.correction[direction]).max(0.0f), 1;
    return out;
}

/// Extrapolates known colors (weight 1) from neighbor to neighbor to directions whose color is unknown
/// (weight 0). With increasing distance, the colors fade to the mean of the known ones.
void continue_colors(const DirectionSphere& sphere, std::vector<Eigen::Array4f>& colors) {
    constexpr int smoothing = 32;          // rounds
    constexpr float from = 8, steps = 24;  // on the sphere, over which the color fades to the mean
    Eigen::Array4f all = Eigen::Array4f::Zero();
    for (const Eigen::Array4f& c : colors) all += c;
    all = all[3] > 0 ? Eigen::Array4f(all / all[3]) : Eigen::Array4f(0.5f, 0.5f, 0.5f, 1);
    std::vector<std::uint8_t> unknown;
    std::vector<float> away(colors.size(), -1);  // steps from the nearest known color
    std::vector<std::uint32_t> front;
    for (std::uint32_t v = 0; v < colors.size(); ++v) {
        unknown.push_back(colors[v][3] == 0);
        if (!unknown[v]) away[v] = 0, front.push_back(v);
    }
    for (float step = 1; !front.empty(); ++step) {
        std::vector<std::uint32_t> next;
        for (const std::uint32_t v : front)
            for (const std::uint32_t u : sphere.neighbors[v]) {
                if (u == DirectionSphere::none || (away[u] >= 0 && away[u] < step)) continue;
                if (away[u] < 0) away[u] = step, next.push_back(u);
                colors[u] += colors[v] / colors[v][3];
            }
        front = std::move(next);
    }
    for (std::size_t v = 0; v < colors.size(); ++v) {
        if (!unknown[v]) continue;
        const float share = std::clamp((away[v] - from) / steps, 0.0f, 1.0f);
        colors[v] = colors[v][3] > 0 ? Eigen::Array4f(colors[v] / colors[v][3]) : all;
        colors[v] += share * (all - colors[v]);
    }
    relax(sphere, unknown, smoothing, colors);
}

}  // namespace

std::vector<Eigen::Array3f> calm_colors(const Backdrop& backdrop, std::span<const CoarseView> views,
                                        const BackdropPaint& paint) {
    constexpr int fine_level = 6;  // about a degree: the colors are smooth
    constexpr int smoothing = 3;   // rounds
    DirectionSphere sphere = direction_sphere(0);
    for (int l = 0; l < fine_level && sphere.directions.size() < backdrop.positions.size(); ++l)
        sphere = divided(sphere);
    const std::size_t n = sphere.directions.size();
    std::vector<Eigen::Array4f> shown(n);
    for (std::size_t v = 0; v < n; ++v) shown[v] = shown_color(backdrop, views, paint, v);
    std::vector<Eigen::Array3f> out(n);
    std::vector<Eigen::Array4f> sky;
    for (const Side side : {Side::sky, Side::above, Side::below}) {
        std::vector<Eigen::Array4f> known = shown;
        for (std::size_t v = 0; v < n; ++v)
            if (side_of(backdrop, v) != side) known[v].setZero();
        if (std::ranges::all_of(known, [](const Eigen::Array4f& c) { return c[3] == 0; })) known = shown;
        continue_colors(sphere, known);
        relax(sphere, std::vector<std::uint8_t>(n, 1), smoothing, known);
        for (std::size_t v = 0; v < n; ++v)
            if (side_of(backdrop, v) == side) out[v] = known[v].head<3>();
        if (side == Side::sky) sky = std::move(known);
        if (side != Side::above || !backdrop.sky.any()) continue;
        // Haze: not far above the horizon, unseen directions take on the sky's color.
        for (std::size_t v = 0; v < n; ++v) {
            const float rise =
                std::clamp(-backdrop.sphere.directions[v].dot(backdrop.sky.down) / lowest_alone, 0.0f, 1.0f);
            if (side_of(backdrop, v) == side && shown[v][3] == 0)
                out[v] += rise * rise * (sky[v].head<3>() - out[v]);
        }
    }
    // The edge between sky and land stays sharp: the color of the land does not bleed into the sky above it.
    std::vector<std::uint8_t> soft;
    for (std::size_t v = 0; v < n; ++v) soft.push_back(shown[v][3] == 0 && !backdrop.is_sky[v]);
    relax(sphere, soft, smoothing, out);
    out.reserve(backdrop.positions.size());
    for (std::size_t v = n; v < backdrop.positions.size(); ++v) {
        auto [a, b] = backdrop.sphere.ends[v];
        // Uses only one end if the other end is on the other side of the sky's outline.
        if (backdrop.is_sky[a] != backdrop.is_sky[v]) a = b;
        if (backdrop.is_sky[b] != backdrop.is_sky[v]) b = a;
        out.push_back((out[a] + out[b]) / 2);
    }
    for (Eigen::Array3f& c : out) c = c.square();
    return out;
}

}  // namespace vantage
