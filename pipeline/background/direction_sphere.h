#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/run/for_each_photo.h"

namespace vantage {

/// Directions spread evenly over the sphere: the vertices of an icosahedron whose triangles are repeatedly
/// divided into four.
struct DirectionSphere {
    static constexpr std::uint32_t none = ~0u;
    std::vector<Eigen::Vector3f> directions;              ///< unit length
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise as seen from the center;
                                                          ///< the four pieces of a triangle are consecutive
    std::vector<std::array<std::uint32_t, 6>> neighbors;  ///< the last is `none` for the first 12 directions
    /// The two ends of the edge that a direction bisects; for each of the first 12 directions, the direction
    /// itself twice.
    std::vector<std::array<std::uint32_t, 2>> ends;
};

/// `level` is the number of subdivisions; the result has 20 * 4^level triangles.
DirectionSphere direction_sphere(int level);

/// The sphere with each triangle divided into four. The first directions of the result are those of `sphere`.
DirectionSphere divided(const DirectionSphere& sphere);

/// Calls `visit` with each number from 0 to `count` - 1 on up to `threads` threads, in large batches.
template <class Visit>
void for_each_direction(std::size_t count, unsigned threads, const Visit& visit) {
    constexpr std::size_t run = 256;
    for_each_photo((count + run - 1) / run, threads, [&](std::size_t r) {
        for (std::size_t i = r * run; i < std::min(count, (r + 1) * run); ++i) visit(i);
    });
}

/// Replaces the values of the directions marked in `open` with the mean of their neighbors' values, `rounds`
/// times. Value: float or an Eigen array.
template <class Value>
void relax(const DirectionSphere& sphere, const std::vector<std::uint8_t>& open, int rounds,
           std::vector<Value>& values) {
    std::vector<Value> next = values;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t v = 0; v < values.size(); ++v) {
            if (!open[v]) continue;
            Value sum = values[sphere.neighbors[v][0]];
            float count = 1;
            for (std::size_t i = 1; i < 6; ++i)
                if (const std::uint32_t u = sphere.neighbors[v][i]; u != DirectionSphere::none)
                    sum += values[u], ++count;
            next[v] = sum / count;
        }
        values.swap(next);
    }
}

}  // namespace vantage
