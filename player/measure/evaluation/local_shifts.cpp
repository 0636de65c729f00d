#include "player/measure/evaluation/local_shifts.h"

#include <Eigen/Core>
#include <limits>

namespace vantage {
namespace {

using Line = Eigen::Map<const Eigen::ArrayXf>;

constexpr int shift_block = cell_margin;  // px: cells and margins consist of whole blocks
static_assert(cell_size == 2 * shift_block);

/// The plane extended by `max_shift` pixels on all sides with its edge pixels.
Plane extended(const Plane& p) {
    Plane out(p.width + 2 * max_shift, p.height + 2 * max_shift);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.row(y)[x] =
                p.row(std::clamp(y - max_shift, 0, p.height - 1))[std::clamp(x - max_shift, 0, p.width - 1)];
    return out;
}

/// Squared differences at one shift, summed over each block of the frame; blocks are in row order.
Plane block_sums(const Plane& photo, const Plane& wide, const Plane& mask, PixelShift s) {
    Plane out((photo.width + shift_block - 1) / shift_block, (photo.height + shift_block - 1) / shift_block);
    Eigen::ArrayXf columns(out.width * shift_block);
    for (int b = 0; b < out.height; ++b) {
        columns.setZero();
        for (int y = b * shift_block; y < std::min(photo.height, (b + 1) * shift_block); ++y)
            columns.head(photo.width) += Line(mask.row(y), photo.width) *
                                         (Line(photo.row(y), photo.width) -
                                          Line(wide.row(y + max_shift + s.y) + max_shift + s.x, photo.width))
                                             .square();
        Eigen::Map<Eigen::ArrayXf>(out.row(b), out.width) =
            columns.reshaped(shift_block, out.width).colwise().sum().transpose();
    }
    return out;
}

float sum_over(const Plane& blocks, Place p) {
    float sum = 0;
    for (int y = p.y / shift_block; y < (p.y + p.height + shift_block - 1) / shift_block; ++y)
        for (int x = p.x / shift_block; x < (p.x + p.width + shift_block - 1) / shift_block; ++x)
            sum += blocks.row(y)[x];
    return sum;
}

/// All shifts, smallest first.
std::vector<PixelShift> shifts() {
    std::vector<PixelShift> out;
    for (int y = -max_shift; y <= max_shift; ++y)
        for (int x = -max_shift; x <= max_shift; ++x) out.push_back({x, y});
    std::ranges::stable_sort(out, {}, [](const PixelShift& s) { return s.x * s.x + s.y * s.y; });
    return out;
}

}  // namespace

std::vector<PixelShift> local_shifts(const Plane& photo, const Plane& picture, const Plane& mask) {
    const Cells cells{photo.width, photo.height};
    const Plane wide = extended(picture);
    std::vector<PixelShift> best(cells.count());
    std::vector<float> least(cells.count(), std::numeric_limits<float>::infinity());
    for (const PixelShift& s : shifts()) {
        const Plane blocks = block_sums(photo, wide, mask, s);
        for (std::size_t c = 0; c < cells.count(); ++c) {
            const float sum = sum_over(blocks, cells.place(c, cell_margin));
            if (sum < least[c]) least[c] = sum, best[c] = s;
        }
    }
    return best;
}

}  // namespace vantage
