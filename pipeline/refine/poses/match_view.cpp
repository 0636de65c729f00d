#include "pipeline/refine/poses/match_view.h"

#include <algorithm>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "base/text/error.h"
#include "base/values/tiling.h"
#include "pipeline/refine/coarse_photo.h"
#include "pipeline/stages/tile_levels.h"

namespace vantage {
namespace {

using package::Type;

cv::Mat depth_of(const PackageReader& package, const package::PhotoRecord& r, std::uint32_t photo,
                 int level) {
    const Level size = level_size(int(r.width), int(r.height), level);
    const std::vector<std::byte> texels = read_level(package, r, photo, Type::depth, level);
    cv::Mat out(size.height, size.width, CV_32F);
    std::memcpy(out.data, texels.data(), texels.size());
    return out;
}

cv::Mat gray_of(const PackageReader& package, const package::PhotoRecord& r, std::uint32_t photo, int level) {
    RgbaImage image = read_pinhole_level(package, r, photo, level);
    cv::Mat gray;
    cv::cvtColor(cv::Mat(image.height, image.width, CV_8UC4, image.rgba.data()), gray, cv::COLOR_RGBA2GRAY);
    return gray;
}

/// Normalizes by local mean and contrast, which vary with exposure, haze and shadow. Detail is preserved.
cv::Mat normalize_contrast(const cv::Mat& gray) {
    cv::Mat mean, square;
    const cv::Size window(25, 25);
    cv::boxFilter(gray, mean, CV_32F, window);
    cv::sqrBoxFilter(gray, square, CV_32F, window);
    cv::Mat out(gray.size(), CV_8U);
    for (int y = 0; y < out.rows; ++y) {
        const auto* v = gray.ptr<std::uint8_t>(y);
        const auto *m = mean.ptr<float>(y), *s = square.ptr<float>(y);
        auto* o = out.ptr<std::uint8_t>(y);
        for (int i = 0; i < out.cols; ++i) {
            const float contrast = std::sqrt(std::max(s[i] - m[i] * m[i], 0.0f)) + 4;
            o[i] = std::uint8_t(std::clamp(128 + 44 * (float(v[i]) - m[i]) / contrast, 0.0f, 255.0f));
        }
    }
    return out;
}

}  // namespace

MatchView read_match_view(const PackageReader& package, const package::PhotoRecord& r, std::uint32_t photo,
                          int long_side) {
    const int l = coarse_level(r, long_side);
    const Level size = level_size(int(r.width), int(r.height), l);
    MatchView out{l, intrinsics(r).at_level(l), cam_from_origin(r), {}, depth_of(package, r, photo, l)};
    cv::Mat gray;
    if (l < int(r.levels)) {
        gray = gray_of(package, r, photo, l);
    } else {
        cv::resize(gray_of(package, r, photo, 0), gray, {size.width, size.height}, 0, 0, cv::INTER_AREA);
    }
    out.gray = normalize_contrast(gray);
    return out;
}

std::shared_ptr<const MatchView> MatchViews::get(std::uint32_t photo, int long_side) const {
    const LruCache<MatchView>* views = nullptr;
    {
        const std::scoped_lock lock(mutex_);
        const auto n = std::size_t(std::max(1, 1600 / long_side));
        views = &sizes_
                     .try_emplace(long_side, 12 * n * n,
                                  [this, long_side](std::uint32_t p) {
                                      return read_match_view(package_, photos_[p], p, long_side);
                                  })
                     .first->second;
    }
    return views->get(photo);
}

}  // namespace vantage
