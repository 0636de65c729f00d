#include "pipeline/refine/prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "base/values/srgb.h"
#include "pipeline/refine/coarse_photo.h"
#include "scene/agreement/color_fit.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

using Color = std::array<float, 3>;

constexpr float no_color = std::numeric_limits<float>::quiet_NaN();

/// The sRGB code, 0 to 255, for the square root of a light value, from a table.
float code_of(float root) {
    constexpr int steps = 2048;
    static const std::vector<float> table = [] {
        std::vector<float> t;
        for (int i = 0; i <= steps; ++i)
            t.push_back(float(255 * srgb_from_linear(std::pow(double(i) / steps, 2))));
        return t;
    }();
    return table[std::size_t(std::clamp(root, 0.0f, 1.0f) * steps + 0.5f)];
}

/// A sighting prepared for blending. Its colors are square roots of light.
struct Blended {
    float weight;
    Color root, smooth;
};

using Colors = Color Blended::*;

/// Corresponds to own_share() in blend.frag.
float own_share(float theta) {
    const float near = shader::own_angle * shader::own_angle;
    return near / (near + theta * theta);
}

float transient_weight(const Alternative& a, const Sighting& s) {
    if (a.transients.empty() || !a.transients[s.photo].data) return 1;
    const auto& grid = a.transients[s.photo];
    const int x = std::min(int(s.x), grid.width - 1), y = std::min(int(s.y), grid.height - 1);
    const float mask = (std::max(float(grid(x, y)), 1.0f) - 1) / 254;
    return mask + (1 - mask) * own_share(s.theta);
}

/// The fraction of a color that keeps its exposure because the color is overexposed, as in refined() in
/// blend.frag.
float white_share(const float (&root)[3], float theta) {
    const float least = std::min({root[0], root[1], root[2]}), light = least * least;
    if (!(light > shader::overexposed)) return 0;
    const float t = std::min((light - shader::overexposed) / (1 - shader::overexposed), 1.0f);
    return t * t * (3 - 2 * t) * (1 - own_share(theta));
}

/// The factor on light that removes the vignetting of a lens, see ColorFit.
float without_vignetting(const Vignetting& f, double radius2) {
    return float(std::exp(log_vignetting_at_square(f, radius2)));
}

/// The square root of light multiplied by a factor, mixed as in refined().
float exposed(float root, float factor, float white) {
    if (!(white > 0) || factor >= 1) return factor * root;
    return root * std::sqrt(factor * factor * (1 - white) + white);
}

std::vector<Blended> blended(const Sightings& sightings, const Alternative& a) {
    std::vector<Color> gain;  // on square roots of light
    for (const auto& g : a.ln_gain)
        gain.push_back({float(std::exp(g[0] / 2)), float(std::exp(g[1] / 2)), float(std::exp(g[2] / 2))});
    std::vector<Blended> out;
    out.reserve(sightings.all.size());
    for (const Sighting& s : sightings.all) {
        Blended& b = out.emplace_back(Blended{s.weight * transient_weight(a, s), {}, {}});
        const float factor = a.vignetting.empty()
                                 ? 1
                                 : std::sqrt(without_vignetting(a.vignetting[s.photo], double(s.radius2)));
        const float white = white_share(s.root, s.theta), smooth_white = white_share(s.smooth, s.theta);
        for (std::size_t c = 0; c < 3; ++c) {
            const float all = factor * (gain.empty() ? 1 : gain[s.photo][c]);
            b.root[c] = exposed(s.root[c], all, white);
            b.smooth[c] = exposed(s.smooth[c], all, smooth_white);
        }
    }
    return out;
}

/// A weighted mean of colors.
struct Mean {
    Color sum{};
    float weight = 0;

    void add(float w, const Color& c) {
        weight += w;
        for (std::size_t k = 0; k < 3; ++k) sum[k] += w * c[k];
    }
    /// The mean as sRGB codes; NaN if the weights are 0. `light`: a factor on the mean.
    Color code(float light = 1) const {
        if (!(weight > 0)) return {no_color, no_color, no_color};
        const float factor = std::sqrt(light) / weight;
        return {code_of(factor * sum[0]), code_of(factor * sum[1]), code_of(factor * sum[2])};
    }
};

/// The photos' blended color at a pixel. `which`: the colors as exposed, or smoothed.
Mean mean_at(const Sightings& s, std::span<const Blended> b, std::size_t pixel, Colors which) {
    Mean mean;
    for (std::size_t i = s.first[pixel]; i < s.first[pixel + 1]; ++i) mean.add(b[i].weight, b[i].*which);
    return mean;
}

/// The color of the surface at `pixel`, blended with the weights at the pixel `other`, from the photos that
/// see both pixels.
Mean mean_with_weights_of(const Sightings& s, std::span<const Blended> b, std::size_t pixel,
                          std::size_t other) {
    Mean mean;
    std::size_t j = s.first[other];
    for (std::size_t i = s.first[pixel]; i < s.first[pixel + 1]; ++i) {
        // The sightings of both pixels are sorted by photo.
        while (j < s.first[other + 1] && s.all[j].photo < s.all[i].photo) ++j;
        if (j == s.first[other + 1]) break;
        if (s.all[j].photo == s.all[i].photo) mean.add(b[j].weight, b[i].smooth);
    }
    return mean;
}

/// Root mean square of the difference over the channels.
double distance(const Color& a, const Color& b) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += double(a[c] - b[c]) * double(a[c] - b[c]);
    return std::sqrt(sum / 3);
}

/// The color step between two neighboring pixels that is due to their weights; empty if the pixels are not on
/// one surface.
std::optional<double> step(const CoarsePhoto& target, const Sightings& s, std::span<const Blended> b,
                           std::span<const Color> smooth, std::size_t i, std::size_t j) {
    const float zi = target.texels[i].z, zj = target.texels[j].z;
    if (!(std::abs(zi - zj) <= float(depth_step) * std::min(zi, zj))) return {};
    const Color &ci = smooth[i], &cj = smooth[j];
    if (!std::isfinite(ci[0]) || !std::isfinite(cj[0])) return {};
    const Color ij = mean_with_weights_of(s, b, i, j).code(), ji = mean_with_weights_of(s, b, j, i).code();
    // If the pixels have no photo in common, the whole step is due to the change of photos.
    const bool common = std::isfinite(ij[0]) && std::isfinite(ji[0]);
    return common ? (distance(ci, ij) + distance(cj, ji)) / 2 : distance(ci, cj);
}

double seams_of(const CoarsePhoto& target, const Sightings& s, std::span<const Blended> b) {
    double sum = 0;
    std::size_t n = 0;
    const auto width = std::size_t(target.k.width), height = std::size_t(target.k.height);
    std::vector<Color> smooth;
    smooth.reserve(width * height);
    for (std::size_t i = 0; i < width * height; ++i)
        smooth.push_back(mean_at(s, b, i, &Blended::smooth).code());
    const auto add = [&](std::size_t i, std::size_t j) {
        if (const auto found = step(target, s, b, smooth, i, j)) sum += *found, ++n;
    };
    // Only every other row and column is used, with hardly any loss of precision.
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t at = y * width + x;
            if (y % 2 == 0 && x + 1 < width) add(at, at + 1);
            if (x % 2 == 0 && y + 1 < height) add(at, at + width);
        }
    return n ? sum / double(n) : 0;
}

/// The vignetting of the predicted photo's own lens, as a factor on light.
float own_vignetting(const CoarsePhoto& target, const Alternative& a, std::size_t pixel) {
    if (a.view_vignetting == Vignetting{}) return 1;
    const double x = double(pixel % std::size_t(target.k.width)) + 0.5,
                 y = double(pixel / std::size_t(target.k.width)) + 0.5;
    const double r = vignetting_radius(target.k, {x, y});
    return 1 / without_vignetting(a.view_vignetting, r * r);
}

/// BT.601.
cv::Mat luminance(const cv::Mat& color, const cv::Scalar& gain) {
    const cv::Matx13f weights(float(0.299 * gain[0]), float(0.587 * gain[1]), float(0.114 * gain[2]));
    cv::Mat out;
    cv::transform(color, out, weights);
    return out;
}

/// SSIM (Wang et al. 2004) with windows normalized to the mask (32FC1 of 0 and 1). Both pictures are 0
/// outside the mask.
double mean_ssim(const cv::Mat& a, const cv::Mat& b, const cv::Mat& mask) {
    const auto blur = [](const cv::Mat& m) {
        cv::Mat out;
        cv::GaussianBlur(m, out, {11, 11}, 1.5, 1.5, cv::BORDER_CONSTANT);
        return out;
    };
    const cv::Mat n = cv::max(blur(mask), 1e-9), ma = blur(a) / n, mb = blur(b) / n,
                  va = cv::max(blur(a.mul(a)) / n - ma.mul(ma), 0),
                  vb = cv::max(blur(b.mul(b)) / n - mb.mul(mb), 0), c = blur(a.mul(b)) / n - ma.mul(mb);
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    const cv::Mat above = (2 * ma.mul(mb) + c1).mul(2 * c + c2),
                  below = (ma.mul(ma) + mb.mul(mb) + c1).mul(va + vb + c2);
    return cv::mean(above / below, mask > 0)[0];
}

/// Mask (255 or 0) of the pixels that have a color in the photo and in all predictions.
cv::Mat scored_pixels(const cv::Mat& own, std::span<const Prediction> predictions) {
    const auto colored = [](const cv::Mat& color) {
        cv::Mat first;
        cv::extractChannel(color, first, 0);
        return cv::Mat(first == first);  // not NaN
    };
    cv::Mat out = colored(own);
    for (const Prediction& p : predictions) out &= colored(p.color);
    cv::erode(out, out, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}), {-1, -1}, 1,
              cv::BORDER_CONSTANT, cv::Scalar(255));
    return out;
}

ValidationScore score_one(const cv::Mat& own, const Prediction& prediction, const cv::Mat& scored,
                          const cv::Mat& mask) {
    ValidationScore s;
    s.pixels = std::size_t(cv::countNonZero(scored));
    s.seams = prediction.seams;
    if (s.pixels == 0) return s;
    cv::Mat picture = cv::Mat::zeros(own.size(), own.type());
    prediction.color.copyTo(picture, scored);
    cv::Scalar gain;
    const cv::Scalar both = cv::sum(own.mul(picture)), square = cv::sum(picture.mul(picture));
    for (int c = 0; c < 3; ++c) gain[c] = both[c] / std::max(square[c], 1e-9);
    const cv::Scalar all = cv::sum(own.mul(own));
    double error = 0;
    for (int c = 0; c < 3; ++c) error += std::max(all[c] - gain[c] * both[c], 0.0);
    s.psnr = 10 * std::log10(255 * 255 / std::max(error / (3.0 * double(s.pixels)), 1e-12));
    s.ssim = mean_ssim(luminance(own, {1, 1, 1}), luminance(picture, gain), mask);
    return s;
}

}  // namespace

Prediction predict(const CoarsePhoto& target, const Sightings& sightings, const Alternative& alternative) {
    const std::vector<Blended> b = blended(sightings, alternative);
    Prediction out{cv::Mat(target.k.height, target.k.width, CV_32FC3), 0};
    for (std::size_t i = 0; i < target.texels.size(); ++i) {
        const Color c = mean_at(sightings, b, i, &Blended::root).code(own_vignetting(target, alternative, i));
        std::ranges::copy(c, out.color.ptr<float>() + 3 * i);
    }
    out.seams = seams_of(target, sightings, b);
    return out;
}

cv::Mat own_color(const CoarsePhoto& photo) {
    cv::Mat out(photo.k.height, photo.k.width, CV_32FC3);
    auto* codes = out.ptr<float>();
    for (const CoarsePhoto::Texel& t : photo.texels)
        for (const float l : t.linear) *codes++ = std::isfinite(l) ? code_of(std::sqrt(l)) : no_color;
    return out;
}

std::vector<ValidationScore> score(const cv::Mat& own, std::span<const Prediction> predictions) {
    const cv::Mat scored = scored_pixels(own, predictions);
    cv::Mat photo = cv::Mat::zeros(own.size(), own.type()), mask;
    own.copyTo(photo, scored);
    scored.convertTo(mask, CV_32F, 1.0 / 255);
    std::vector<ValidationScore> out;
    for (const Prediction& p : predictions) out.push_back(score_one(photo, p, scored, mask));
    return out;
}

}  // namespace vantage
