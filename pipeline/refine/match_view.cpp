#include "pipeline/refine/match_view.h"

#include <algorithm>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "pipeline/join_tiles.h"
#include "scene/error.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

using package::Type;

cv::Mat joined(const PackageReader& package, Type type, std::uint32_t photo, int level, const Level& size,
               int cv_type) {
    const package::DirectoryEntry* e = package.find(type, photo, std::uint32_t(level));
    if (!e) throw Error(Exit::damaged, package.path().string() + ": a photo's pixels are missing");
    const std::vector<std::byte> texels = join_tiles(package, *e, size);
    package.forget(package.raw(*e));
    cv::Mat out(size.height, size.width, cv_type);
    std::memcpy(out.data, texels.data(), texels.size());
    return out;
}

/// Photos differ in exposure, and what they show in haze and shade: what matters is where its detail lies.
cv::Mat normalised(const cv::Mat& grey) {
    cv::Mat x, mean, square;
    grey.convertTo(x, CV_32F);
    const cv::Size window(25, 25);
    cv::boxFilter(x, mean, CV_32F, window);
    cv::sqrBoxFilter(x, square, CV_32F, window);
    cv::Mat out(grey.size(), CV_8U);
    for (int y = 0; y < out.rows; ++y) {
        const auto *v = x.ptr<float>(y), *m = mean.ptr<float>(y), *s = square.ptr<float>(y);
        auto* o = out.ptr<std::uint8_t>(y);
        for (int i = 0; i < out.cols; ++i) {
            const float contrast = std::sqrt(std::max(s[i] - m[i] * m[i], 0.0f)) + 4;
            o[i] = std::uint8_t(std::clamp(128 + 44 * (v[i] - m[i]) / contrast, 0.0f, 255.0f));
        }
    }
    return out;
}

}  // namespace

MatchView read_match_view(const PackageReader& package, const package::PhotoRecord& r, std::uint32_t photo,
                          int long_side) {
    int l = mask_level;
    while (l + 1 < int(r.levels) && int(std::max(r.width, r.height)) >> l > long_side) ++l;
    const Level size = level_size(int(r.width), int(r.height), l);
    const Intrinsics full = intrinsics(r);
    const double s = 1.0 / (1 << l);
    MatchView out{l,
                  {size.width, size.height, full.fx * s, full.fy * s, full.cx * s, full.cy * s},
                  cam_from_origin(r),
                  {},
                  joined(package, Type::depth, photo, l, size, CV_32F)};
    cv::Mat grey;
    if (l < int(r.levels)) {
        cv::cvtColor(joined(package, Type::tiles, photo, l, size, CV_8UC4), grey, cv::COLOR_RGBA2GRAY);
    } else {
        cv::Mat finer;
        const Level whole{int(r.width), int(r.height)};
        cv::cvtColor(joined(package, Type::tiles, photo, 0, whole, CV_8UC4), finer, cv::COLOR_RGBA2GRAY);
        cv::resize(finer, grey, {size.width, size.height}, 0, 0, cv::INTER_AREA);
    }
    out.grey = normalised(grey);
    return out;
}

}  // namespace vantage
