#include "pipeline/align/shared_features.h"

#include <cmath>
#include <map>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "pipeline/photos/photos.h"
#include "pipeline/run/for_each_photo.h"

namespace vantage {
namespace {

constexpr float ratio = 0.8f;      ///< largest distance of the best match relative to the second best
constexpr double contrast = 0.02;  ///< half of OpenCV's default: stone and plaster have little texture

cv::Ptr<cv::SIFT> detector(int features) { return cv::SIFT::create(features, 3, contrast); }

/// The offset of a feature from the center of its blob, in pixels to the right and down: a quarter in OpenCV
/// before 4.8, which ignores pixel centers when it doubles the image.
double shift_of_features() {
    constexpr int size = 64;
    cv::Mat blob(size, size, CV_8U);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            blob.at<std::uint8_t>(y, x) =
                std::uint8_t(200 * std::exp(-(std::pow(x - size / 2, 2) + std::pow(y - size / 2, 2)) / 8));
    std::vector<cv::KeyPoint> found;
    detector(1)->detect(blob, found);
    return found.empty() ? 0 : std::round(8 * (double(found[0].pt.x) - size / 2)) / 8;
}

struct Features {
    std::vector<Eigen::Vector2d> pixels;  ///< full size
    cv::Mat descriptors;                  ///< one row per feature
};

Features find_features(const PhotoInput& photo, const FeatureSettings& how) {
    const Intrinsics& k = photo.camera.intrinsics;
    ReducedPhoto small = read_reduced_photo(photo.file, {k.width, k.height}, how.long_side);
    RgbaImage& image = small.image;
    const cv::Mat rgba(image.height, image.width, CV_8UC4, image.rgba.data());
    cv::Mat gray, opaque;
    cv::cvtColor(rgba, gray, cv::COLOR_RGBA2GRAY);
    cv::extractChannel(rgba, opaque, 3);
    std::vector<cv::KeyPoint> found;
    Features out;
    detector(how.features)->detectAndCompute(gray, opaque, found, out.descriptors);
    static const double to_center = 0.5 - shift_of_features();
    const Eigen::Vector2d scale(small.scale[0], small.scale[1]);
    // OpenCV's pixel centers have integer coordinates.
    for (const cv::KeyPoint& p : found)
        out.pixels.push_back((Eigen::Vector2d(double(p.pt.x), double(p.pt.y)).array() + to_center)
                                 .matrix()
                                 .cwiseProduct(scale));
    return out;
}

/// The best match of each feature if it is much better than the second best, otherwise -1.
std::vector<int> best_matches(const Features& from, const Features& to) {
    std::vector<std::vector<cv::DMatch>> two;
    cv::BFMatcher(cv::NORM_L2).knnMatch(from.descriptors, to.descriptors, two, 2);
    std::vector<int> out(from.pixels.size(), -1);
    for (const auto& m : two)
        if (m.size() == 2 && m[0].distance < ratio * m[1].distance)
            out[std::size_t(m[0].queryIdx)] = m[0].trainIdx;
    return out;
}

std::vector<SharedFeature> match(const TwoPhotos& pair, const Features& a, const Features& b) {
    if (a.pixels.size() < 2 || b.pixels.size() < 2) return {};
    const std::vector<int> there = best_matches(a, b), back = best_matches(b, a);
    std::vector<SharedFeature> out;
    for (std::size_t i = 0; i < there.size(); ++i)
        if (there[i] >= 0 && back[std::size_t(there[i])] == int(i))
            out.push_back({pair[0], pair[1], a.pixels[i], b.pixels[std::size_t(there[i])]});
    return out;
}

}  // namespace

std::vector<SharedFeature> shared_features(std::span<const PhotoInput> photos,
                                           std::span<const TwoPhotos> pairs, const FeatureSettings& how) {
    std::map<std::uint32_t, Features> features;
    for (const TwoPhotos& pair : pairs)
        for (const std::uint32_t photo : pair) features[photo];
    std::vector<std::pair<const std::uint32_t, Features>*> each;
    for (auto& entry : features) each.push_back(&entry);
    for_each_photo(each.size(), how.threads, [&](std::size_t i) {
        try {
            each[i]->second = find_features(photos[each[i]->first], how);
        } catch (const Error&) {  // reported when the photo is prepared
        }
    });
    std::vector<std::vector<SharedFeature>> found(pairs.size());
    for_each_photo(pairs.size(), how.threads, [&](std::size_t i) {
        found[i] = match(pairs[i], features.at(pairs[i][0]), features.at(pairs[i][1]));
    });
    std::vector<SharedFeature> out;
    for (const auto& f : found) out.insert(out.end(), f.begin(), f.end());
    return out;
}

}  // namespace vantage
