#include "pipeline/surroundings/direction_sphere.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace vantage {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

DirectionSphere icosahedron() {
    DirectionSphere s;
    const float p = (1 + std::sqrt(5.0f)) / 2;
    s.directions = {{-1, p, 0},  {1, p, 0},  {-1, -p, 0}, {1, -p, 0}, {0, -1, p},  {0, 1, p},
                    {0, -1, -p}, {0, 1, -p}, {p, 0, -1},  {p, 0, 1},  {-p, 0, -1}, {-p, 0, 1}};
    for (Eigen::Vector3f& d : s.directions) d.normalize();
    s.triangles = {{0, 5, 11},  {0, 1, 5},  {0, 7, 1},  {0, 10, 7}, {0, 11, 10}, {1, 9, 5}, {5, 4, 11},
                   {11, 2, 10}, {10, 6, 7}, {7, 8, 1},  {3, 4, 9},  {3, 2, 4},   {3, 6, 2}, {3, 8, 6},
                   {3, 9, 8},   {4, 5, 9},  {2, 11, 4}, {6, 10, 2}, {8, 7, 6},   {9, 1, 8}};
    return s;
}

void divide(DirectionSphere& s) {
    std::unordered_map<std::uint64_t, std::uint32_t> midpoints;  // by edge
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [at, added] =
            midpoints.try_emplace(std::uint64_t(low) << 32 | high, std::uint32_t(s.directions.size()));
        if (added) s.directions.push_back((s.directions[a] + s.directions[b]).normalized());
        return at->second;
    };
    std::vector<Triangle> pieces;
    pieces.reserve(4 * s.triangles.size());
    for (const auto [a, b, c] : s.triangles) {
        const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
        pieces.insert(pieces.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    s.triangles = std::move(pieces);
}

void find_neighbors(DirectionSphere& s) {
    constexpr std::uint32_t none = DirectionSphere::none;
    s.neighbors.assign(s.directions.size(), {none, none, none, none, none, none});
    // Around a direction, each neighbor starts one of its triangles' opposite edges.
    for (const Triangle& t : s.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            auto& around = s.neighbors[t[i]];
            *std::ranges::find(around, none) = t[(i + 1) % 3];
        }
}

}  // namespace

DirectionSphere direction_sphere(int level) {
    DirectionSphere s = icosahedron();
    for (int l = 0; l < level; ++l) divide(s);
    find_neighbors(s);
    return s;
}

}  // namespace vantage
