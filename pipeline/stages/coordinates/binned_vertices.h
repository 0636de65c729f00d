#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// Bounds of blocks of consecutive vertices, padded to a multiple of `lanes` with empty blocks.
struct VertexBlocks {
    std::vector<std::int32_t> left, right, top, bottom;  ///< positions, inclusive
    std::vector<float> inverse;  ///< least 1/z of the vertices that are not hidden yet, or +inf
};

/// The vertices inside a map, sorted into square bins row by row, so that the vertices in adjacent bins of a
/// row are contiguous. Within a crowded bin they follow a Z-order curve, so that blocks of vertices are
/// compact.
struct BinnedVertices {
    static constexpr int bin_bits = position_bits + 2;  ///< bins of 4x4 pixels
    /// Bins with more vertices than this are crowded, and so are rows of bins with more on average.
    static constexpr std::size_t crowded = 128;
    int columns = 0, rows = 0;
    std::vector<std::uint32_t> first;  ///< start of each bin, and the end of the last bin
    /// One element per vertex, followed by at least `lanes` elements of padding, which no triangle hides.
    std::vector<std::int32_t> x, y, vertex, hidden;
    std::vector<float> inverse;
    /// levels[0] has one block per `lanes` vertices, levels[i] one per `lanes` blocks of levels[i - 1]. The
    /// last level has at most `lanes` blocks.
    std::vector<VertexBlocks> levels;

    /// To be called after vertices in block `block` of levels[0] have been hidden.
    void update_depth(std::size_t block);
};

BinnedVertices bin_vertices(const PhotoProjection& projection);

}  // namespace vantage
