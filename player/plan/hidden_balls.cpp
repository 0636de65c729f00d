#include "player/plan/hidden_balls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "player/plan/triangle_corners.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

void show_all(PlanScene& s) {
    for (const auto& [triangle, corners] : s.hidden.triangles)
        std::ranges::copy(corners, s.joined.indices.begin() + 3 * std::ptrdiff_t(triangle));
    for (const auto& [vertex, color] : s.hidden.colors) s.surrounding_colors[vertex] = color;
    s.hidden = {};
}

bool is_in(const Ball& ball, const Eigen::Vector3d& place) {
    return (place - ball.center).squaredNorm() <= ball.radius * ball.radius;
}

void hide_triangles(PlanScene& s, const package::ClusterRecord& c, const Ball& ball) {
    const double reach = ball.radius + double(c.radius) * (1 + 1e-5);
    if (!is_in({ball.center, reach}, {c.center[0], c.center[1], c.center[2]})) return;
    for (std::uint32_t t = c.first_triangle; t < c.first_triangle + c.triangles; ++t) {
        const auto corners = corners_of(s, t);
        if (!corners) return;
        const auto& [p, q, r] = *corners;
        std::uint32_t* const v = &s.joined.indices[3 * std::size_t(t)];
        if (!is_in(ball, (p + q + r) / 3) || (v[0] == v[1] && v[1] == v[2])) continue;
        s.hidden.triangles.push_back({t, {v[0], v[1], v[2]}});
        v[1] = v[2] = v[0];
    }
}

/// The background vertices in the balls.
std::vector<std::uint32_t> vertices_in(const PlanScene& s, std::span<const Ball> balls) {
    const std::size_t first = s.positions.size() - s.surrounding_colors.size();
    std::vector<std::uint32_t> out;
    for (std::size_t v = first; v < s.positions.size(); ++v)
        if (std::ranges::any_of(balls,
                                [&](const Ball& b) { return is_in(b, s.positions[v].cast<double>()); }))
            out.push_back(std::uint32_t(v - first));
    return out;
}

/// For each background vertex in `of`, the vertices of its triangles.
std::vector<std::vector<std::uint32_t>> neighbors_of(const PlanScene& s, std::span<const std::uint32_t> of) {
    std::vector<std::vector<std::uint32_t>> out(s.surrounding_colors.size());
    std::vector<bool> asked(out.size());
    for (const std::uint32_t v : of) asked[v] = true;
    const std::size_t first = s.positions.size() - out.size();
    for (std::size_t i = 3 * s.first_triangle_behind(); i < s.indices.size(); ++i)
        if (const std::size_t v = s.indices[i] - first; asked[v])
            for (const std::size_t other : {i / 3 * 3, i / 3 * 3 + 1, i / 3 * 3 + 2})
                if (other != i) out[v].push_back(std::uint32_t(s.indices[other] - first));
    return out;
}

/// Interpolates the colors of hidden vertices by relaxation.
void hide_background(PlanScene& s, std::span<const Ball> balls) {
    constexpr int rounds = 200;
    const std::vector<std::uint32_t> hidden = vertices_in(s, balls);
    if (hidden.empty()) return;
    const auto neighbors = neighbors_of(s, hidden);
    std::vector<Eigen::Array3f> colors;
    for (const auto& c : s.surrounding_colors) colors.emplace_back(c[0], c[1], c[2]);
    for (int round = 0; round < rounds; ++round)
        for (const std::uint32_t v : hidden) {
            Eigen::Array3f sum = Eigen::Array3f::Zero();
            for (const std::uint32_t n : neighbors[v]) sum += colors[n];
            if (!neighbors[v].empty()) colors[v] = sum / float(neighbors[v].size());
        }
    for (const std::uint32_t v : hidden) {
        auto& color = s.surrounding_colors[v];
        s.hidden.colors.push_back({v, color});
        for (int c = 0; c < 3; ++c) color[std::size_t(c)] = std::uint8_t(std::lround(colors[v][c]));
        color[3] = shader::hidden_background;
    }
}

}  // namespace

void hide(PlanScene& s, std::span<const Ball> balls) {
    show_all(s);
    if (balls.empty()) return;
    if (s.joined.indices.empty()) {
        s.joined.indices.assign(s.indices.begin(), s.indices.end());
        s.indices = s.joined.indices;
    }
    for (const Ball& ball : balls)
        for (const package::ClusterRecord& c : s.clusters_of_mesh()) hide_triangles(s, c, ball);
    if (s.has_background()) hide_background(s, balls);
}

}  // namespace vantage
