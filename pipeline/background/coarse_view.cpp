#include "pipeline/background/coarse_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "base/values/tiling.h"
#include "pipeline/run/for_each_photo.h"
#include "scene/agreement/read_level.h"

namespace vantage {
namespace {

constexpr int long_side = 192;

CoarseView read_view(const PackageReader& package, const package::PhotoRecord& r, std::uint32_t photo,
                     const PhotoColors& colors) {
    const int level = coarse_level(r, long_side);
    CoarseView v;
    v.photo = photo;
    v.k = intrinsics(r).at_level(level);
    v.pose = cam_from_origin(r);
    const auto linear = read_linear_colors(package, r, photo, level);
    const auto depth = read_level(package, r, photo, package::Type::depth, level);
    v.z.resize(linear.size());
    std::memcpy(v.z.data(), depth.data(), 4 * v.z.size());
    const auto& gain = colors.ln_gain[photo];
    v.ln.assign(linear.size(), Eigen::Array3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    for (std::size_t at = 0; at < linear.size(); ++at) {
        if (std::isnan(linear[at][0])) continue;
        ++v.pixels;
        if (v.z[at] != std::numeric_limits<float>::infinity()) continue;
        ++v.open;
        const Eigen::Vector2d pixel(double(int(at) % v.k.width) + 0.5, double(int(at) / v.k.width) + 0.5);
        const double vignetting = log_vignetting(colors.vignetting[photo], vignetting_radius(v.k, pixel));
        Eigen::Array3f c;
        for (int i = 0; i < 3; ++i)
            c[i] = linear[at][std::size_t(i)] * float(std::exp(gain[std::size_t(i)] + vignetting));
        v.ln[at] = ln_of(c);
    }
    return v;
}

}  // namespace

std::vector<std::uint8_t> gaps_in(const CoarseView& v, const PackageReader& package,
                                  const package::PhotoRecord& r) {
    const Level size = level_size(int(r.width), int(r.height), weight_map_level);
    const auto depth = read_level(package, r, v.photo, package::Type::depth, weight_map_level);
    const int shift = coarse_level(r, long_side) - weight_map_level;
    std::vector<std::uint8_t> out(v.z.size(), 0);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float z;
            std::memcpy(&z, &depth[4 * (std::size_t(y) * std::size_t(size.width) + std::size_t(x))], 4);
            if (z == std::numeric_limits<float>::infinity())
                out[std::size_t(y >> shift) * std::size_t(v.k.width) + std::size_t(x >> shift)] = 1;
        }
    cv::Mat gaps(v.k.height, v.k.width, CV_8U, out.data());
    cv::dilate(gaps, gaps, cv::Mat::ones(2 * gap_reach + 1, 2 * gap_reach + 1, CV_8U));
    return out;
}

std::vector<CoarseView> read_coarse_views(const PackageReader& package,
                                          std::span<const package::PhotoRecord> photos,
                                          std::span<const std::uint32_t> of, const PhotoColors& colors,
                                          unsigned threads) {
    std::vector<CoarseView> views(of.size());
    for_each_photo(of.size(), threads,
                   [&](std::size_t i) { views[i] = read_view(package, photos[of[i]], of[i], colors); });
    return views;
}

std::vector<std::uint32_t> spread_photos(std::span<const package::PhotoRecord> photos, std::size_t most) {
    std::vector<std::uint32_t> usable, chosen;
    for (std::uint32_t i = 0; i < photos.size(); ++i)
        if (photos[i].levels) usable.push_back(i);
    std::vector<double> distance(usable.size(), std::numeric_limits<double>::infinity());
    double size = 0;
    for (const std::uint32_t i : usable)
        size = std::max(
            size, (cam_from_origin(photos[i]).center() - cam_from_origin(photos[usable[0]]).center()).norm());
    const double unit = size > 0 ? 1 / size : 0;
    while (chosen.size() < std::min(most, usable.size())) {
        const auto at = std::size_t(std::ranges::max_element(distance) - distance.begin());
        chosen.push_back(usable[at]);
        const Pose last = cam_from_origin(photos[usable[at]]);
        for (std::size_t i = 0; i < usable.size(); ++i) {
            const Pose p = cam_from_origin(photos[usable[i]]);
            const double d =
                unit * (p.center() - last.center()).norm() + (p.direction() - last.direction()).norm();
            distance[i] = std::min(distance[i], i == at ? -1 : d);
        }
    }
    std::ranges::sort(chosen);
    return chosen;
}

}  // namespace vantage
