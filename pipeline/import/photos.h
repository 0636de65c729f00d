#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/scene_input.h"

namespace vantage {

/// What a photo's header says.
struct PhotoHeader {
    PhotoSize size;       ///< as stored
    std::string profile;  ///< description of its ICC profile, empty where it has none or it is sRGB
};
/// Throws Error(input).
PhotoHeader read_photo_header(const std::filesystem::path& file);

/// RGBA8, sRGB, straight alpha, rows from the top.
struct RgbaPhoto {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Decodes a photo: JPEG by libjpeg-turbo, all else by OpenImageIO (grey, 16-bit, float, alpha, CMYK). Pixels
/// stay as stored, because cameras are calibrated on stored pixels; where the stored size is the expected one
/// turned, the photo's EXIF orientation is applied. Throws Error(input) for a cut, broken or differently
/// sized photo.
RgbaPhoto read_photo(const std::filesystem::path& file, PhotoSize expected);
/// The same from the file's bytes, where they are in memory already.
RgbaPhoto decode_photo(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       PhotoSize expected);

}  // namespace vantage
