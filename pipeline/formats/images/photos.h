#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "pipeline/formats/images/image_files.h"
#include "scene/error.h"

namespace vantage {

/// Its orientation is read only where the file is not a plain JPEG. Throws Error(input).
PhotoHeader read_photo_header(const std::filesystem::path& file);

/// Decodes a photo: JPEG by libjpeg-turbo, all else by OpenImageIO (grey, 16-bit, float, alpha, CMYK). Pixels
/// stay as stored, because cameras are calibrated on stored pixels; where the stored size is the expected one
/// turned, the photo's EXIF orientation is applied. Throws Error(input) for a cut, broken or differently
/// sized photo.
RgbaImage read_photo(const std::filesystem::path& file, PhotoSize expected);
/// The same from the file's bytes, where they are in memory already.
RgbaImage decode_photo(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       PhotoSize expected);

/// The message of an error about this photo without the file's name and place: "JPEG is damaged ...".
std::string reason_of(const Error& error, const std::filesystem::path& file);

}  // namespace vantage
