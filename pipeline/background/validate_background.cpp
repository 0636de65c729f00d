#include "pipeline/background/validate_background.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>

#include "base/values/quantile.h"
#include "base/values/srgb.h"
#include "base/values/tiling.h"
#include "pipeline/background/view_sample.h"
#include "pipeline/refine/prediction.h"
#include "pipeline/refine/verdict.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/photo_projection.h"
#include "pipeline/visibility/triangle_map.h"
#include "scene/agreement/shared_discs.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

constexpr double worth_having = 0.01;   ///< minimum fraction of a photo's pixels that are open
constexpr double least_compared = 400;  ///< texels in all photos; with fewer, the fractions are scaled down
constexpr double same_enough = 25;      ///< dB, for a background that moves with the camera
constexpr double plain_enough = 30;     ///< dB
constexpr double close_codes = 25;      ///< maximum difference in each channel, sRGB codes
/// Measured: 0.17 on a head that was moved between series of photos, 0.41 and 0.80 in front of facades.
constexpr double agreed_around_object = 0.5, agreed_before_front = 0.3;

/// A picture of NaNs with the size of the view.
cv::Mat blank(const CoarseView& view) {
    return {view.k.height, view.k.width, CV_32FC3, cv::Scalar::all(std::numeric_limits<double>::quiet_NaN())};
}

void set(cv::Mat& picture, std::size_t at, const Eigen::Array3f& linear) {
    auto* pixel = picture.ptr<float>() + 3 * at;
    for (int c = 0; c < 3; ++c)
        pixel[c] = float(255 * srgb_from_linear(std::clamp(double(linear[c]), 0.0, 1.0)));
}

/// The view's open texels.
cv::Mat own_background(const CoarseView& view) {
    cv::Mat out = blank(view);
    for (std::size_t at = 0; at < view.ln.size(); ++at)
        if (view.is_open(at)) set(out, at, linear_of(view.ln[at]));
    return out;
}

/// The weighted mean of colors in square roots of light, as in the player.
class Blend {
  public:
    void add(const Eigen::Array3f& linear, float weight) {
        sum_.head<3>() += weight * linear.max(0.0f).sqrt();
        sum_[3] += weight;
    }
    bool empty() const { return !(sum_[3] > 0); }
    Eigen::Array3f color() const { return (sum_.head<3>() / sum_[3]).square(); }

  private:
    Eigen::Array4f sum_ = Eigen::Array4f::Zero();
};

float angle_weight(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return std::exp(-std::atan2(a.cross(b).norm(), a.dot(b)) / shader::default_sharpness);
}

/// The view predicted from the backdrop, painted with the other views.
cv::Mat from_backdrop(const CoarseView& view, const Backdrop& backdrop, std::span<const CoarseView> others) {
    cv::Mat out = blank(view);
    std::vector<std::uint32_t> indices;
    for (const auto& t : backdrop.sphere.triangles) indices.insert(indices.end(), t.begin(), t.end());
    const Eigen::Vector2d near_far = depth_range(backdrop.positions, view.pose);
    const PhotoProjection projection = project_model(backdrop.positions, view.k, view.pose, near_far.x());
    const std::vector<float> values(backdrop.positions.size(), 0);
    const TriangleMap map = rasterize(projection, indices, values);
    const Eigen::Vector3f eye = view.pose.center().cast<float>();
    const Eigen::Matrix3f world = view.pose.R.transpose().cast<float>();
    for (std::size_t at = 0; at < view.ln.size(); ++at) {
        if (!view.is_open(at) || !(map.inverse_depth[at] > 0)) continue;
        const float x = float(int(at) % view.k.width) + 0.5f, y = float(int(at) / view.k.width) + 0.5f;
        const Eigen::Vector3f ray((x - float(view.k.cx)) / float(view.k.fx),
                                  (y - float(view.k.cy)) / float(view.k.fy), 1);
        const Eigen::Vector3f point = eye + world * ray / map.inverse_depth[at];
        Blend blend;
        for (const CoarseView& o : others) {
            const ViewSample s = sample(o, in_camera(o, point), 1);
            if (s.kind != ViewSample::open) continue;
            const Eigen::Vector3f back = o.pose.center().cast<float>() - point;
            blend.add(linear_of(s.ln), std::max(angle_weight(eye - point, back), 1e-12f));
        }
        if (!blend.empty()) set(out, at, blend.color());
    }
    return out;
}

/// Two predictions of the view. The first assumes that the background moves with the camera, and blends the
/// same pixels of the other views, with the largest weights for the nearest views. The second assumes that
/// the background has a single color.
std::array<cv::Mat, 2> without_geometry(const CoarseView& view, std::span<const CoarseView> others) {
    std::array<cv::Mat, 2> out{blank(view), blank(view)};
    const Eigen::Vector3d eye = view.pose.center();
    double nearest = std::numeric_limits<double>::infinity();
    for (const CoarseView& o : others) nearest = std::min(nearest, (o.pose.center() - eye).norm());
    for (std::size_t at = 0; at < view.ln.size(); ++at) {
        if (!view.is_open(at)) continue;
        const int x = int(at) % view.k.width, y = int(at) / view.k.width;
        Blend blend;
        for (const CoarseView& o : others) {
            const auto i = std::size_t(x * o.k.width / view.k.width),
                       j = std::size_t(y * o.k.height / view.k.height);
            const std::size_t there = j * std::size_t(o.k.width) + i;
            if (!o.is_open(there)) continue;
            const double distance = (o.pose.center() - eye).norm() / std::max(nearest, 1e-30);
            blend.add(linear_of(o.ln[there]), float(std::exp(-2 * distance)) + 1e-12f);
        }
        if (!blend.empty()) set(out[0], at, blend.color());
        set(out[1], at, Eigen::Array3f::Constant(0.2f));
    }
    return out;
}

/// The views other than photo `without`, with color corrections that were computed without it.
std::vector<CoarseView> exposed_without(std::span<const CoarseView> views, std::uint32_t without,
                                        const PhotoColors& used, const PhotoColors& fitted) {
    std::vector<CoarseView> out;
    for (const CoarseView& v : views) {
        if (v.photo == without) continue;
        CoarseView& changed = out.emplace_back(v);
        Eigen::Array3f factor;
        for (int c = 0; c < 3; ++c)
            factor[c] = float(
                std::exp(fitted.ln_gain[v.photo][std::size_t(c)] - used.ln_gain[v.photo][std::size_t(c)]));
        for (std::size_t at = 0; at < changed.ln.size(); ++at)
            if (v.is_open(at)) changed.ln[at] = ln_of(linear_of(v.ln[at]) * factor);
    }
    return out;
}

/// For each pixel in `where`, whether a prediction is close to the photo after applying the gain per channel
/// that fits these pixels best.
std::vector<bool> close_pixels(const cv::Mat& own, const cv::Mat& predicted,
                               const std::vector<cv::Point>& where) {
    cv::Vec3d both{}, squares{};
    const auto pixel = [](const cv::Mat& of, const cv::Point& p) { return cv::Vec3d(of.at<cv::Vec3f>(p)); };
    for (const cv::Point& p : where) {
        both += pixel(own, p).mul(pixel(predicted, p));
        squares += pixel(predicted, p).mul(pixel(predicted, p));
    }
    std::vector<bool> out;
    for (const cv::Point& p : where) {
        bool close = true;
        for (int c = 0; c < 3; ++c) {
            const double gain = both[c] / std::max(squares[c], 1e-9);
            close &= std::abs(pixel(own, p)[c] - gain * pixel(predicted, p)[c]) < close_codes;
        }
        out.push_back(close);
    }
    return out;
}

/// The number of pixels that one color does not explain, and how many more pixels the backdrop explains than
/// one color does.
struct Explained {
    double all = 0, by_backdrop = 0;
};
Explained explained_by(const cv::Mat& backdrop, const cv::Mat& plain, const cv::Mat& own) {
    std::vector<cv::Point> where;
    for (int y = 0; y < own.rows; ++y)
        for (int x = 0; x < own.cols; ++x)
            if (!std::isnan(own.at<cv::Vec3f>(y, x)[0]) && !std::isnan(backdrop.at<cv::Vec3f>(y, x)[0]))
                where.emplace_back(x, y);
    const auto close = [&](const cv::Mat& predicted) {
        return double(std::ranges::count(close_pixels(own, predicted, where), true));
    };
    const double by_plain = close(plain);
    return {double(where.size()) - by_plain, close(backdrop) - by_plain};
}

/// The scores of a photo's predictions from the backdrop, from the same pixels of other photos, and from one
/// color.
struct Predicted {
    std::string name;
    ValidationScore backdrop, same, plain;
    Explained explained;
};

Predicted predicted(const CoarseView& view, std::span<const CoarseView> others, const MeshPlanes& mesh,
                    const std::string& name) {
    const Backdrop backdrop = estimate_backdrop(others, mesh, validated_detail, 1);
    const auto [same, plain] = without_geometry(view, others);
    const std::array predictions{Prediction{from_backdrop(view, backdrop, others)}, Prediction{same},
                                 Prediction{plain}};
    const cv::Mat own = own_background(view);
    const std::vector<ValidationScore> scores = score(own, predictions);
    return {name, scores[0], scores[1], scores[2],
            explained_by(predictions[0].color, predictions[2].color, own)};
}

}  // namespace

BackgroundVerdict validate_background(const CoarseViews& all, const SampledPhotos& of, const MeshPlanes& mesh,
                                      std::size_t most, unsigned threads) {
    const PhotoSamples some = samples_to_fit(of.samples);
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < all.views.size(); ++i)
        if (double(all.views[i].open) > worth_having * double(all.views[i].pixels)) candidates.push_back(i);
    const std::size_t count = std::min(most, candidates.size());
    std::vector<Predicted> folds(count);
    for_each_photo(count, threads, [&](std::size_t f) {
        const CoarseView& view = all.views[candidates[f * candidates.size() / count]];
        const std::vector<CoarseView> others = exposed_without(
            all.views, view.photo, all.colors, fit_without(some.spans(), of.lens, view.photo, false));
        if (have_parallax(others)) folds[f] = predicted(view, others, mesh, of.photos[view.photo].name);
    });
    std::vector<ValidatedPhoto> gain;
    BackgroundVerdict out;
    double pixels = 0;
    Explained explained;
    int compared_photos = 0;
    for (const Predicted& p : folds) {
        gain.push_back({p.name, p.plain, p.backdrop});
        const auto compared = double(p.plain.pixels);
        pixels += compared;
        compared_photos += p.explained.all > 0;
        explained.all += p.explained.all;
        explained.by_backdrop += p.explained.by_backdrop;
        out.with_camera += p.same.psnr > std::max(same_enough, p.backdrop.psnr) ? compared : 0;
        out.plain += p.plain.psnr > plain_enough ? compared : 0;
    }
    for (double* share : {&out.with_camera, &out.plain}) *share /= std::max(pixels, least_compared);
    out.gain = summarize(gain);
    if (compared_photos >= min_validated_photos && explained.all >= double(fewest_pixels))
        out.agreed = explained.by_backdrop / explained.all;
    return out;
}

std::string BackgroundVerdict::objection(KindOfScan kind) const {
    if (plain > 0.5) return "the background is plain";
    if (with_camera > 0.5)
        return "the background moves with the camera, as it does when the object is turned";
    const double least = kind == KindOfScan::object ? agreed_around_object : agreed_before_front;
    if (agreed.value_or(1) >= least) return "";
    return kind == KindOfScan::object ? "too little around an object" : "too little";
}

}  // namespace vantage
