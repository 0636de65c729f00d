#include "pipeline/photos/reduced.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace vantage {

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
