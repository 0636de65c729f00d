#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// Which triangle every pixel of a map sees, row by row.
struct TriangleMap {
    static constexpr std::uint32_t none = ~0u;
    int width = 0, height = 0;
    std::vector<float> inverse_depth;      ///< 1/z, 0 where nothing is seen
    std::vector<std::uint32_t> triangles;  ///< number in `indices`, or none
    /// A vertices' value, linear along the triangle, times 1/z; no number on triangles of more than some 60
    /// pixels.
    std::vector<float> value;
};

/// Rasterises triangles (three indices each) on the processor, cut off at the near plane, from both sides.
/// Corners are snapped to 1/256 of a pixel, so that triangles that share an edge leave no gap; pixel centres
/// on an edge belong to both. Of equal depths the first counts, small triangles before large ones.
TriangleMap rasterize(const PhotoProjection& projection, std::span<const std::uint32_t> indices,
                      std::span<const float> values);

}  // namespace vantage
