#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// The nearest triangle at every pixel, row by row.
struct TriangleMap {
    static constexpr std::uint32_t none = ~0u;
    int width = 0, height = 0;
    std::vector<float> inverse_depth;      ///< 1/z, 0 if nothing is seen
    std::vector<std::uint32_t> triangles;  ///< index of the triangle, or none
    /// The value interpolated from the vertices, divided by z; NaN on triangles larger than about 60 pixels.
    std::vector<float> value;
};

/// Rasterizes triangles (three indices each) on the CPU, without backface culling and clipped against the
/// near plane. `values`: one per vertex. Corners are snapped to 1/256 pixel, so that triangles that share an
/// edge leave no gap; a pixel center on the edge is inside both triangles. At equal depth the triangle drawn
/// first wins; small triangles are drawn before large ones.
TriangleMap rasterize(const PhotoProjection& projection, std::span<const std::uint32_t> indices,
                      std::span<const float> values);

}  // namespace vantage
