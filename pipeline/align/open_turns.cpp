#include "pipeline/align/open_turns.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "pipeline/align/feature_errors.h"

namespace vantage {
namespace {

constexpr std::size_t max_tried = 300, fewest_agreeing = 30;
constexpr double near_line = 0.002;  ///< epipolar error, as a fraction of the longer side
constexpr double clearly_more = 2;

/// The rotation or reflection about the photo's center that an EXIF orientation describes (Exif 2.3, 4.6.4).
Eigen::Matrix2d turn_of(int orientation) {
    const bool swaps = orientation >= 5;
    const double x = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7 ? -1 : 1,
                 y = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8 ? -1 : 1;
    Eigen::Matrix2d out;
    out << (swaps ? 0 : x), (swaps ? x : 0), (swaps ? y : 0), (swaps ? 0 : y);
    return out;
}

/// The features after the photos in `which` have been turned by their `open_turn`.
std::vector<SharedFeature> turned(std::vector<SharedFeature> features, std::span<const PhotoInput> photos,
                                  const std::vector<bool>& which) {
    const auto turn = [&](std::uint32_t photo, Eigen::Vector2d& pixel) {
        if (!which[photo]) return;
        const Intrinsics& k = photos[photo].camera.intrinsics;
        const Eigen::Vector2d middle(k.width / 2.0, k.height / 2.0);
        pixel = middle + turn_of(photos[photo].open_turn) * (pixel - middle);
    };
    for (SharedFeature& f : features) turn(f.a, f.in_a), turn(f.b, f.in_b);
    return features;
}

/// Tests turns of photos using the features that photos share.
class Judge {
  public:
    Judge(std::span<const PhotoInput> photos, std::vector<SharedFeature> features)
        : photos_(photos), features_(std::move(features)) {
        for (const PhotoInput& p : photos) cameras_.push_back(p.camera);
    }

    /// Whether features agree if the photos in `which` are turned, and disagree if those in `without` are.
    bool agree_only(const std::vector<bool>& which, const std::vector<bool>& without) const {
        return agree_only(features_, which, without);
    }
    /// Like the function above, but uses only the features of one photo.
    bool agree_only(std::uint32_t photo, const std::vector<bool>& which,
                    const std::vector<bool>& without) const {
        std::vector<SharedFeature> own;
        std::ranges::copy_if(features_, std::back_inserter(own),
                             [&](const SharedFeature& f) { return f.a == photo || f.b == photo; });
        return agree_only(own, which, without);
    }

  private:
    /// The number of features near their epipolar lines.
    std::size_t agreeing(std::span<const SharedFeature> features, const std::vector<bool>& which) const {
        return agreeing_features(turned({features.begin(), features.end()}, photos_, which), cameras_,
                                 near_line)
            .size();
    }
    bool agree_only(std::span<const SharedFeature> of, const std::vector<bool>& which,
                    const std::vector<bool>& without) const {
        const std::size_t then = agreeing(of, which), now = agreeing(of, without);
        return then >= fewest_agreeing && double(then) >= clearly_more * double(now);
    }

    std::span<const PhotoInput> photos_;
    std::vector<SharedFeature> features_;
    std::vector<Camera> cameras_;
};

std::vector<bool> with(std::vector<bool> which, std::uint32_t photo) {
    which[photo] = true;
    return which;
}

}  // namespace

void take_as_displayed(PhotoInput& photo) {
    Intrinsics& k = photo.camera.intrinsics;
    const double longer = (k.height - k.width) / 2.0;
    k.cx += longer;
    k.cy -= longer;
    std::swap(k.width, k.height);
    std::swap(photo.decoded.width, photo.decoded.height);
}

OpenTurns find_open_turns(std::span<const PhotoInput> photos, const FeatureSettings& how) {
    OpenTurns out;
    std::vector<std::uint32_t> open;
    std::vector<bool> is_tried(photos.size(), false), all = is_tried;
    for (std::uint32_t i = 0; i < photos.size(); ++i)
        if (photos[i].open_turn) open.push_back(i), all[i] = true;
    if (open.empty()) return {};
    for (std::size_t i = 0; i < std::min(open.size(), max_tried); ++i) is_tried[open[i]] = true;
    constexpr std::size_t ranks[] = {0, 1};
    std::vector<TwoPhotos> pairs = neighboring_photos(photos, photos.size(), ranks);
    std::erase_if(pairs, [&](const TwoPhotos& p) { return !is_tried[p[0]] && !is_tried[p[1]]; });
    const Judge validate(photos, shared_features(photos, pairs, how));
    const std::vector<bool> none(photos.size(), false);
    if (validate.agree_only(all, none)) return {open, {}};
    std::vector<bool> wrong = none;
    for (const std::uint32_t i : open)
        if (validate.agree_only(i, with(none, i), none) || validate.agree_only(i, all, none)) wrong[i] = true;
    for (const std::uint32_t i : open)
        if (wrong[i])
            out.found.push_back(i);
        else if (!validate.agree_only(i, wrong, with(wrong, i)))
            out.unknown.push_back(i);
    return out;
}

}  // namespace vantage
