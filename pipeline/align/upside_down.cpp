#include "pipeline/align/upside_down.h"

#include <algorithm>
#include <iterator>

#include "pipeline/align/feature_errors.h"

namespace vantage {
namespace {

constexpr std::size_t most_tried = 12, fewest_agreeing = 30;
constexpr double near_line = 0.002;  ///< an epipolar error, as a share of the longer side
constexpr double clearly_more = 2;

/// The features with the pixels of some photos turned by 180 degrees.
std::vector<SharedFeature> turned(std::vector<SharedFeature> features, std::span<const PhotoInput> photos,
                                  const std::vector<bool>& which) {
    const auto turn = [&](std::uint32_t photo, Eigen::Vector2d& pixel) {
        const Intrinsics& k = photos[photo].camera.intrinsics;
        if (which[photo]) pixel = Eigen::Vector2d(k.width, k.height) - pixel;
    };
    for (SharedFeature& f : features) turn(f.a, f.in_a), turn(f.b, f.in_b);
    return features;
}

/// How many features lie near their epipolar lines.
std::size_t agreeing(std::span<const SharedFeature> features, std::span<const PhotoInput> photos,
                     std::span<const Camera> cameras, const std::vector<bool>& which) {
    return agreeing_features(turned({features.begin(), features.end()}, photos, which), cameras, near_line)
        .size();
}

}  // namespace

std::vector<std::uint32_t> upside_down_photos(std::span<const PhotoInput> photos,
                                              const FeatureSettings& how) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < photos.size() && open.size() < most_tried; ++i)
        if (photos[i].open_turn) open.push_back(i);
    if (open.empty()) return {};
    std::vector<Camera> cameras;
    for (const PhotoInput& p : photos) cameras.push_back(p.camera);
    constexpr std::size_t ranks[] = {0, 1};
    std::vector<TwoPhotos> pairs = neighboring_photos(photos, photos.size(), ranks);
    std::erase_if(pairs, [&](const TwoPhotos& p) {
        return std::ranges::count(open, p[0]) == 0 && std::ranges::count(open, p[1]) == 0;
    });
    const std::vector<SharedFeature> features = shared_features(photos, pairs, how);
    std::vector<bool> none(photos.size(), false), all = none;
    for (std::uint32_t i = 0; i < photos.size(); ++i) all[i] = photos[i].open_turn != 0;
    const auto agree_only = [&](std::span<const SharedFeature> of, const std::vector<bool>& which) {
        const std::size_t as_is = agreeing(of, photos, cameras, none),
                          then = agreeing(of, photos, cameras, which);
        return then >= fewest_agreeing && double(then) >= clearly_more * double(as_is);
    };
    if (agree_only(features, all)) return open;
    std::vector<std::uint32_t> out;
    for (const std::uint32_t photo : open) {
        std::vector<SharedFeature> own;
        std::ranges::copy_if(features, std::back_inserter(own),
                             [&](const SharedFeature& f) { return f.a == photo || f.b == photo; });
        std::vector<bool> alone = none;
        alone[photo] = true;
        if (agree_only(own, alone) || agree_only(own, all)) out.push_back(photo);
    }
    return out;
}

}  // namespace vantage
