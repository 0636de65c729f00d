#include "tests/bench/measure/exhibit.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/files/make_folder.h"
#include "base/text/error.h"
#include "tests/bench/scenes/crop.h"

namespace vantage::bench {

Window worst_window(const Picture& a, const Picture& b) {
    Window best{0, 0, std::min(360, a.width), std::min(240, a.height)};
    constexpr int step = 24;
    const int columns = (a.width + step - 1) / step, rows = (a.height + step - 1) / step;
    // Sum the differences over blocks first, then over all windows that consist of whole blocks.
    std::vector<double> blocks(std::size_t(columns * rows), 0);
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const std::uint8_t *p = texel(a, x, y), *q = texel(b, x, y);
            if (p[3] < 128) continue;
            for (int c = 0; c < 3; ++c) {
                const double d = double(p[c]) - double(q[c]);
                blocks[std::size_t(y / step * columns + x / step)] += d * d;
            }
        }
    double most = -1;
    for (int y = 0; y + best.height <= a.height; y += step)
        for (int x = 0; x + best.width <= a.width; x += step) {
            double sum = 0;
            for (int j = y / step; j < std::min(rows, (y + best.height) / step); ++j)
                for (int i = x / step; i < std::min(columns, (x + best.width) / step); ++i)
                    sum += blocks[std::size_t(j * columns + i)];
            if (sum <= most) continue;
            most = sum;
            best.x = x, best.y = y;
        }
    return best;
}

Picture gray_picture(const std::vector<std::uint8_t>& gray, int width, int height) {
    Picture out{width, height, {}, {}};
    for (const std::uint8_t v : gray) out.rgba.insert(out.rgba.end(), {v, v, v, 255});
    return out;
}

Picture enlarged(const Picture& p, int width, int height) {
    Picture out{width, height, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto from = [](int at, int here, int there) {
                return int(std::int64_t(at) * here / there);
            };
            const std::uint8_t* t = texel(p, from(x, p.width, width), from(y, p.height, height));
            out.rgba.insert(out.rgba.end(), t, t + 4);
        }
    return out;
}

Exhibit keep_exhibit(const std::filesystem::path& folder, const std::string& name, const std::string& caption,
                     const Picture& picture, const Window& window) {
    cv::Mat out(window.height, window.width, CV_8UC3);
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            const std::uint8_t* p = texel(picture, x + window.x, y + window.y);
            out.at<cv::Vec3b>(y, x) = p[3] < 128 ? cv::Vec3b(255, 0, 255) : cv::Vec3b(p[2], p[1], p[0]);
        }
    make_folder(folder);
    const std::filesystem::path file = folder / (name + ".jpg");
    if (!cv::imwrite(file.string(), out, {cv::IMWRITE_JPEG_QUALITY, 92}))
        throw Error(Exit::storage, file.string() + ": cannot be written");
    return {caption, folder.filename().string() + "/" + name + ".jpg"};
}

}  // namespace vantage::bench
