#pragma once
#include <filesystem>
#include <vector>

namespace vantage {

/// A comparison of two pictures with a photo, on the pixels that both pictures color.
struct PictureDifference {
    double psnr = 0, ssim = 0;  ///< of the first picture, after the best gain per channel
    double psnr_difference = 0, ssim_difference = 0;  ///< second picture minus first
};

/// The pictures must have the photo's size. With `whole_frame`, holes are filled with the photo's mean color
/// in the holes, which is the best uniform color. Otherwise, only pixels that both pictures color are
/// compared. Throws Error(input).
PictureDifference compare_pictures(const std::filesystem::path& photo, const std::filesystem::path& first,
                                   const std::filesystem::path& second, bool whole_frame);

}  // namespace vantage
