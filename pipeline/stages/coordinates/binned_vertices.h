#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// Bounds of blocks of consecutive vertices, padded to a multiple of `lanes` with empty blocks.
struct VertexBlocks {
    std::vector<std::int32_t> left, right, top, bottom;  ///< positions, inclusive
    std::vector<float> inverse;                          ///< least 1/z of vertices not yet hidden, or +inf
};

/// The vertices inside a map, sorted into square bins row by row, so that those in a range of bins of one row
/// are contiguous. Within a crowded bin they follow a Z-order curve, so that blocks of them are compact.
struct BinnedVertices {
    static constexpr int bin_bits = position_bits + 2;  ///< bins of 4x4 pixels
    static constexpr std::size_t crowded = 128;         ///< vertices in a bin, or on average in a row of bins
    int columns = 0, rows = 0;
    std::vector<std::uint32_t> first;  ///< start of each bin, and the end of the last
    /// One element per vertex, and at least `lanes` of padding that nothing hides.
    std::vector<std::int32_t> x, y, vertex, hidden;
    std::vector<float> inverse;
    /// levels[0] has one block per `lanes` vertices, levels[i] one per `lanes` blocks of levels[i - 1]. The
    /// last has at most `lanes` blocks.
    std::vector<VertexBlocks> levels;

    /// To be called after vertices of block `block` of levels[0] were hidden.
    void update_depth(std::size_t block);
};

BinnedVertices bin_vertices(const PhotoProjection& projection);

}  // namespace vantage
