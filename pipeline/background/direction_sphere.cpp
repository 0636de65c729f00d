#include "pipeline/background/direction_sphere.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vantage {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

void find_neighbors(DirectionSphere& s) {
    constexpr std::uint32_t none = DirectionSphere::none;
    s.neighbors.assign(s.directions.size(), {none, none, none, none, none, none});
    // Each neighbor of a direction is the start of the opposite edge in one of the adjacent triangles.
    for (const Triangle& t : s.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            auto& around = s.neighbors[t[i]];
            *std::ranges::find(around, none) = t[(i + 1) % 3];
        }
}

DirectionSphere icosahedron() {
    DirectionSphere s;
    const float p = (1 + std::sqrt(5.0f)) / 2;
    s.directions = {{-1, p, 0},  {1, p, 0},  {-1, -p, 0}, {1, -p, 0}, {0, -1, p},  {0, 1, p},
                    {0, -1, -p}, {0, 1, -p}, {p, 0, -1},  {p, 0, 1},  {-p, 0, -1}, {-p, 0, 1}};
    for (Eigen::Vector3f& d : s.directions) d.normalize();
    s.triangles = {{0, 5, 11},  {0, 1, 5},  {0, 7, 1},  {0, 10, 7}, {0, 11, 10}, {1, 9, 5}, {5, 4, 11},
                   {11, 2, 10}, {10, 6, 7}, {7, 8, 1},  {3, 4, 9},  {3, 2, 4},   {3, 6, 2}, {3, 8, 6},
                   {3, 9, 8},   {4, 5, 9},  {2, 11, 4}, {6, 10, 2}, {8, 7, 6},   {9, 1, 8}};
    for (std::uint32_t v = 0; v < s.directions.size(); ++v) s.ends.push_back({v, v});
    find_neighbors(s);
    return s;
}

}  // namespace

DirectionSphere divided(const DirectionSphere& s) {
    DirectionSphere out{.directions = s.directions, .triangles = {}, .neighbors = {}, .ends = s.ends};
    const std::size_t count = s.directions.size() + s.triangles.size() * 3 / 2;
    out.directions.reserve(count);
    out.ends.reserve(count);
    out.triangles.reserve(4 * s.triangles.size());
    // The midpoint of the edge to each neighbor with a larger index.
    std::vector<std::array<std::uint32_t, 6>> middles(s.directions.size());
    for (auto& m : middles) m.fill(DirectionSphere::none);
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto& around = s.neighbors[low];
        std::uint32_t& at = middles[low][std::size_t(std::ranges::find(around, high) - around.begin())];
        if (at == DirectionSphere::none) {
            at = std::uint32_t(out.directions.size());
            out.directions.push_back((s.directions[a] + s.directions[b]).normalized());
            out.ends.push_back({low, high});
        }
        return at;
    };
    for (const auto [a, b, c] : s.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        out.triangles.insert(out.triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    find_neighbors(out);
    return out;
}

DirectionSphere direction_sphere(int level) {
    DirectionSphere s = icosahedron();
    for (int l = 0; l < level; ++l) s = divided(s);
    return s;
}

}  // namespace vantage
