#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "scene/package/package_reader.h"

namespace vantage {

/// The opaque part of a mesh: its first clusters, triangles and vertices. Of the effect `transparency`, all
/// clusters of triangles with a vertex whose alpha is below 255 come after it.
struct OpaquePart {
    std::uint32_t clusters, triangles, vertices;
};

/// Whether triangle `t` has a vertex that is not opaque. Vertices out of range are opaque.
inline bool is_transparent(std::span<const std::uint32_t> indices, std::size_t t,
                           std::span<const std::array<std::uint8_t, 4>> colors) {
    const auto clear = [&](std::uint32_t v) { return v < colors.size() && colors[v][3] < 255; };
    return clear(indices[3 * t]) || clear(indices[3 * t + 1]) || clear(indices[3 * t + 2]);
}

/// The clusters whose first triangle is opaque, up to the first one that is not; the vertices that they use.
OpaquePart opaque_part(std::span<const package::ClusterRecord> clusters,
                       std::span<const std::uint32_t> indices,
                       std::span<const std::array<std::uint8_t, 4>> colors);

/// The whole mesh if the effect is off. The package must have its shape (scene/package/package_shape.h).
OpaquePart opaque_part(const PackageReader& package);

/// Why a package with the effect is damaged: no alpha, or a cluster of both kinds or out of order. Nothing if
/// it is valid, or if the effect is off. The other chunks must have their shape.
std::optional<std::string> transparency_damage(const PackageReader& package);

}  // namespace vantage
