#include "pipeline/costs/picture_costs.h"

#include <limits>
#include <opencv2/imgproc.hpp>

#include "base/text/error.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/refine/prediction.h"

namespace vantage {
namespace {

/// sRGB codes, NaN where alpha is below one half.
cv::Mat colors_of(const std::filesystem::path& file) {
    RgbaImage image = image_files().read_unprofiled(file);
    const cv::Mat rgba(image.height, image.width, CV_8UC4, image.rgba.data());
    cv::Mat rgb, alpha, out;
    cv::cvtColor(rgba, rgb, cv::COLOR_RGBA2RGB);
    cv::extractChannel(rgba, alpha, 3);
    rgb.convertTo(out, CV_32FC3);
    out.setTo(cv::Scalar::all(std::numeric_limits<double>::quiet_NaN()), alpha < 128);
    return out;
}

cv::Mat holes_of(const cv::Mat& colors) {
    cv::Mat first;
    cv::extractChannel(colors, first, 0);
    return ~cv::Mat(first == first);  // NaN
}

cv::Mat filled(cv::Mat picture, const cv::Mat& photo) {
    const cv::Mat holes = holes_of(picture);
    picture.setTo(cv::mean(photo, holes & ~holes_of(photo)), holes);
    return picture;
}

}  // namespace

PictureDifference compare_pictures(const std::filesystem::path& photo, const std::filesystem::path& first,
                                   const std::filesystem::path& second, bool whole_frame) {
    const cv::Mat own = colors_of(photo);
    std::vector<Prediction> pictures{{colors_of(first)}, {colors_of(second)}};
    for (Prediction& p : pictures) {
        if (p.color.size() != own.size())
            throw Error(Exit::internal, second.string() + ": has a different size than the photo's view");
        if (whole_frame) p.color = filled(p.color, own);
    }
    const std::vector<ValidationScore> s = score(own, pictures);
    return {s[0].psnr, s[0].ssim, s[1].psnr - s[0].psnr, s[1].ssim - s[0].ssim};
}

}  // namespace vantage
