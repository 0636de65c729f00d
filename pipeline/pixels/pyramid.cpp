#include "pipeline/pixels/pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "values/grid.h"

namespace vantage {
void cut_tile(std::span<const std::byte> texels, const Level& level, std::size_t number,
              std::span<std::byte> tile) {
    const int row = int(number) / level.columns(), column = int(number) % level.columns();
    const int x0 = column * tile_content - tile_border;
    const int first = std::max(0, -x0), last = std::min(tile_size, level.width - x0);
    const Grid<const std::byte> rows{texels.data(), 4 * level.width, level.height};
    std::byte* to = tile.data();
    for (int y = 0; y < tile_size; ++y, to += tile_size * 4) {
        const int sy = std::clamp(row * tile_content + y - tile_border, 0, level.height - 1);
        const std::byte* from = rows.row(sy).data();
        for (int x = 0; x < first; ++x) std::memcpy(to + 4 * x, from, 4);
        std::memcpy(to + 4 * first, from + 4 * std::size_t(x0 + first), 4 * std::size_t(last - first));
        for (int x = last; x < tile_size; ++x)
            std::memcpy(to + 4 * x, from + 4 * std::size_t(level.width - 1), 4);
    }
}

Level thumbnail_size(int width, int height, int longest) {
    const double s = std::min(1.0, double(longest) / std::max(width, height));
    return {std::max(1, int(std::lround(width * s))), std::max(1, int(std::lround(height * s)))};
}

RgbaImage reduced(const RgbaImage& image, const Level& size) {
    RgbaImage out = blank_image(size.width, size.height);
    out.opaque = image.opaque;
    const cv::Mat from(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.rgba.data()));
    cv::Mat to(size.height, size.width, CV_8UC4, out.rgba.data());
    // Below half size, bilinear interpolation would skip pixels.
    const bool above_half = image.width < 2 * size.width && image.height < 2 * size.height;
    cv::resize(from, to, to.size(), 0, 0, above_half ? cv::INTER_LINEAR : cv::INTER_AREA);
    return out;
}

}  // namespace vantage
