#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/photos/color_profile.h"

namespace vantage {

/// The contents of a JPEG before its first scan.
struct JpegPhoto {
    std::string flaw;  ///< the reason why the file cannot be read; if empty, the rest is valid
    int width = 0, height = 0;
    int orientation = 1;  ///< EXIF, 1 to 8
    PixelColors colors = PixelColors::rgb;
    /// The ICC profile, assembled from its segments (ICC.1, Annex B.4); no bytes if segments are missing.
    std::optional<std::vector<std::byte>> profile;
};

/// `jpeg`: the file, or its beginning up to the first scan.
JpegPhoto read_jpeg_photo(std::span<const std::byte> jpeg);

}  // namespace vantage
