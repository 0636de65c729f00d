#include "pipeline/stages/coordinates/binned_vertices.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/values/simd.h"

namespace vantage {
namespace {

constexpr auto block_size = std::size_t(lanes);
constexpr float infinite = std::numeric_limits<float>::infinity();

/// Spreads the low 16 bits to the even bit positions.
std::uint32_t spread(std::uint32_t v) {
    v &= 0xffff;
    v = (v | v << 8) & 0x00ff00ff;
    v = (v | v << 4) & 0x0f0f0f0f;
    v = (v | v << 2) & 0x33333333;
    return (v | v << 1) & 0x55555555;
}

/// Counting sort into bins; fills `first` and `vertex`.
void sort_into_bins(const PhotoProjection& p, BinnedVertices& s) {
    const auto in_frame = [&](const ProjectedVertex& v) {
        return v.inverse > 0 && v.x >= 0 && v.y >= 0 && v.x >> BinnedVertices::bin_bits < s.columns &&
               v.y >> BinnedVertices::bin_bits < s.rows;
    };
    const auto bin_of = [&](const ProjectedVertex& v) {
        return std::size_t(v.y >> BinnedVertices::bin_bits) * std::size_t(s.columns) +
               std::size_t(v.x >> BinnedVertices::bin_bits);
    };
    // Counts are shifted by two bins, so that first[bin + 1] is the insertion position of `bin` while the
    // bins are filled, and the start of bin + 1 afterwards.
    s.first.assign(std::size_t(s.columns) * std::size_t(s.rows) + 2, 0);
    for (const ProjectedVertex& v : p.vertices)
        if (in_frame(v)) ++s.first[bin_of(v) + 2];
    for (std::size_t i = 2; i < s.first.size(); ++i) s.first[i] += s.first[i - 1];
    s.vertex.resize(s.first.back());
    for (std::size_t i = 0; i < p.vertices.size(); ++i)
        if (const ProjectedVertex& v = p.vertices[i]; in_frame(v))
            s.vertex[s.first[bin_of(v) + 1]++] = std::int32_t(i);
    s.first.pop_back();
}

/// Sorts the vertices of crowded bins along a Z-order curve. A bin is 2^16 positions wide.
void sort_crowded_bins(const PhotoProjection& p, BinnedVertices& s) {
    static_assert(BinnedVertices::bin_bits == 16);
    std::vector<std::pair<std::uint32_t, std::int32_t>> keys;
    for (std::size_t bin = 0; bin + 1 < s.first.size(); ++bin) {
        const std::size_t start = s.first[bin], count = s.first[bin + 1] - start;
        if (count <= BinnedVertices::crowded) continue;
        keys.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const ProjectedVertex& v = p.vertices[std::size_t(s.vertex[start + i])];
            keys[i] = {spread(std::uint32_t(v.x)) | spread(std::uint32_t(v.y)) << 1, s.vertex[start + i]};
        }
        std::ranges::sort(keys);
        for (std::size_t i = 0; i < count; ++i) s.vertex[start + i] = keys[i].second;
    }
}

VertexBlocks empty_blocks(std::size_t count) {
    constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min(),
                           high = std::numeric_limits<std::int32_t>::max();
    count = (count + block_size - 1) / block_size * block_size;
    const std::vector<std::int32_t> none_low(count, high), none_high(count, low);
    return {none_low, none_high, none_low, none_high, std::vector<float>(count, infinite)};
}

void add_levels(BinnedVertices& s) {
    std::size_t count = s.first.back();
    const auto add = [&](const std::vector<std::int32_t>& left, const std::vector<std::int32_t>& right,
                         const std::vector<std::int32_t>& top, const std::vector<std::int32_t>& bottom,
                         const std::vector<float>& inverse) {
        VertexBlocks b = empty_blocks((count + block_size - 1) / block_size);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t k = i / block_size;
            b.left[k] = std::min(b.left[k], left[i]), b.right[k] = std::max(b.right[k], right[i]);
            b.top[k] = std::min(b.top[k], top[i]), b.bottom[k] = std::max(b.bottom[k], bottom[i]);
            b.inverse[k] = std::min(b.inverse[k], inverse[i]);
        }
        s.levels.push_back(std::move(b));
        count = (count + block_size - 1) / block_size;
    };
    add(s.x, s.x, s.y, s.y, s.inverse);
    while (count > block_size) {
        const VertexBlocks& b = s.levels.back();
        add(b.left, b.right, b.top, b.bottom, b.inverse);
    }
}

}  // namespace

void BinnedVertices::update_depth(std::size_t block) {
    float least = infinite;
    for (std::size_t i = block * block_size; i < (block + 1) * block_size; ++i)
        if (!hidden[i]) least = std::min(least, inverse[i]);
    for (std::size_t l = 0; levels[l].inverse[block] != least;) {
        levels[l].inverse[block] = least;
        if (l + 1 == levels.size()) return;
        block /= block_size;
        const auto children = levels[l++].inverse.begin() + std::ptrdiff_t(block * block_size);
        least = *std::min_element(children, children + std::ptrdiff_t(block_size));
    }
}

BinnedVertices bin_vertices(const PhotoProjection& p) {
    constexpr int pixels = 1 << (BinnedVertices::bin_bits - position_bits);
    BinnedVertices s;
    s.columns = (p.intrinsics.width + pixels - 1) / pixels;
    s.rows = (p.intrinsics.height + pixels - 1) / pixels;
    sort_into_bins(p, s);
    sort_crowded_bins(p, s);
    const std::size_t count = s.first.back(), padded = (count / block_size + 2) * block_size;
    s.vertex.resize(padded, -1);
    s.x.assign(padded, 0);
    s.y.assign(padded, 0);
    s.hidden.assign(padded, 0);
    s.inverse.assign(padded, infinite);
    for (std::size_t i = 0; i < count; ++i) {
        const ProjectedVertex& v = p.vertices[std::size_t(s.vertex[i])];
        s.x[i] = v.x, s.y[i] = v.y, s.inverse[i] = v.inverse;
    }
    add_levels(s);
    return s;
}

}  // namespace vantage
