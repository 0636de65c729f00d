#include "pipeline/refine/coarse_photo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "base/values/tiling.h"
#include "pipeline/stages/borders.h"
#include "pipeline/stages/tile_levels.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

using package::Type;

/// Computes `smooth` from the texels that have a color and show the model.
void smooth_colors(CoarsePhoto& photo) {
    const cv::Size window(9, 9);
    cv::Mat color(photo.k.height, photo.k.width, CV_32FC4, cv::Scalar::all(0));
    for (std::size_t i = 0; i < photo.texels.size(); ++i) {
        const CoarsePhoto::Texel& t = photo.texels[i];
        auto* c = color.ptr<float>() + 4 * i;
        if (std::isfinite(t.z) && std::isfinite(t.linear[0])) std::copy_n(t.linear, 3, c), c[3] = 1;
    }
    cv::boxFilter(color, color, -1, window, {-1, -1}, false, cv::BORDER_CONSTANT);
    for (std::size_t i = 0; i < photo.texels.size(); ++i) {
        const auto* c = color.ptr<float>() + 4 * i;
        for (std::size_t k = 0; k < 3; ++k)
            photo.texels[i].smooth[k] = c[3] > 0.5f ? c[k] / c[3] : std::numeric_limits<float>::quiet_NaN();
    }
}

}  // namespace

Eigen::Array4f SquareMeans::around(float x, float y) const {
    const float column = 2 * x, row = 2 * y;  // in corner coordinates
    const int i = std::clamp(int(column), 0, width - 1), j = std::clamp(int(row), 0, height - 1),
              right = std::min(i + 1, width - 1), below = std::min(j + 1, height - 1);
    const float u = column - float(i), v = row - float(j);
    const auto at = [&](int c, int r) -> const Eigen::Array4f& {
        return colors[std::size_t(r) * std::size_t(width) + std::size_t(c)];
    };
    return (1 - v) * ((1 - u) * at(i, j) + u * at(right, j)) +
           v * ((1 - u) * at(i, below) + u * at(right, below));
}

SquareMeans square_means(std::span<const std::array<float, 3>> colors, int width, int height) {
    if (colors.empty()) return {};
    SquareMeans out{width + 1, height + 1, {}};
    out.colors.reserve(std::size_t(out.width) * std::size_t(out.height));
    for (int y = 0; y <= height; ++y) {
        const auto *above = &colors[std::size_t(std::max(y - 1, 0)) * std::size_t(width)],
                   *below = &colors[std::size_t(std::min(y, height - 1)) * std::size_t(width)];
        const auto both = [&](int x) {
            const auto &a = above[x], &b = below[x];
            return Eigen::Array4f(a[0] + b[0], a[1] + b[1], a[2] + b[2], 0);
        };
        Eigen::Array4f left = both(0);
        for (int x = 0; x <= width; ++x) {
            const Eigen::Array4f right = both(std::min(x, width - 1));
            out.colors.emplace_back((left + right) / 4);
            left = right;
        }
    }
    return out;
}

CoarsePhoto every_second_texel(const CoarsePhoto& photo) {
    CoarsePhoto out;
    const Intrinsics& k = photo.k;
    // The ray of the first texel stays the same.
    out.k = {(k.width + 1) / 2, (k.height + 1) / 2, k.fx / 2, k.fy / 2, (k.cx + 0.5) / 2, (k.cy + 0.5) / 2};
    out.pose = photo.pose;
    out.focal = photo.focal;
    for (int y = 0; y < k.height; y += 2)
        for (int x = 0; x < k.width; x += 2) out.texels.push_back(photo.grid()(x, y));
    return out;
}

CoarsePhoto read_coarse_photo(const PackageReader& package, const package::PhotoRecord& r,
                              std::uint32_t photo, int level) {
    CoarsePhoto out;
    out.k = intrinsics(r).at_level(level);
    out.pose = cam_from_origin(r);
    out.focal = r.fx;
    const auto colors = read_linear_colors(package, r, photo, level);
    const auto weight_maps = read_level(package, r, photo, Type::weight_maps, level),
               z = read_level(package, r, photo, Type::depth, level);
    const float texel = std::ldexp(1.0f, level), ramp = shader::reference_width / float(r.width);
    out.texels.resize(out.grid().size());
    for (int y = 0; y < out.k.height; ++y)
        for (int x = 0; x < out.k.width; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(out.k.width) + std::size_t(x);
            CoarsePhoto::Texel& t = out.texels[at];
            std::memcpy(&t.z, &z[4 * at], 4);
            std::ranges::copy(colors[at], t.linear);
            const float px = (float(x) + 0.5f) * texel, py = (float(y) + 0.5f) * texel,
                        inside = std::min({px, py, float(r.width) - px, float(r.height) - py}),
                        edge =
                            float(std::to_integer<int>(weight_maps[4 * at + 2])) / 255 * float(border_width);
            t.weight = std::clamp(inside * ramp / shader::frame_ramp, shader::frame_least, 1.0f) *
                       std::clamp(edge / shader::edge_ramp, shader::edge_least, 1.0f);
        }
    smooth_colors(out);
    const int finer_level = std::min(level - 1, std::max(int(r.levels) - 1, 0));
    const Level size = level_size(int(r.width), int(r.height), finer_level);
    out.means = square_means(read_linear_colors(package, r, photo, finer_level), size.width, size.height);
    return out;
}

}  // namespace vantage
