#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "scene/package/package_reader.h"

namespace vantage {

/// The opaque part of a mesh: its first clusters, triangles and vertices. With the effect `transparency`, it
/// is followed by the clusters of the triangles that have a vertex with alpha below 255.
struct OpaquePart {
    std::uint32_t clusters, triangles, vertices;
};

/// Whether triangle `t` has a vertex that is not opaque. Vertices that are out of range count as opaque.
inline bool is_transparent(std::span<const std::uint32_t> indices, std::size_t t,
                           std::span<const std::array<std::uint8_t, 4>> colors) {
    const auto clear = [&](std::uint32_t v) { return v < colors.size() && colors[v][3] < 255; };
    return clear(indices[3 * t]) || clear(indices[3 * t + 1]) || clear(indices[3 * t + 2]);
}

/// The number of leading clusters whose first triangle is opaque, and the numbers of triangles and vertices
/// in them.
OpaquePart opaque_part(std::span<const package::ClusterRecord> clusters,
                       std::span<const std::uint32_t> indices,
                       std::span<const std::array<std::uint8_t, 4>> colors);

/// The whole mesh if the effect is off. The package's shape must be valid (scene/package/package_shape.h).
OpaquePart opaque_part(const PackageReader& package);

/// The reason why a package with the effect is damaged: it has no alpha, or a cluster is out of order or
/// has both opaque and transparent triangles. Empty if the package is valid or the effect is off. The shape
/// of the other chunks must be valid.
std::optional<std::string> transparency_damage(const PackageReader& package);

}  // namespace vantage
