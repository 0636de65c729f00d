#pragma once
#include <array>
#include <filesystem>
#include <span>
#include <string>

#include "base/text/error.h"
#include "pipeline/photos/image_files.h"

namespace vantage {

/// Reads a photo's header. Throws Error(input).
PhotoHeader read_photo_header(const std::filesystem::path& file);

/// Decodes a photo with libjpeg-turbo if it is a JPEG, otherwise with OpenImageIO (gray, 16-bit, float,
/// alpha, CMYK). Colors with an ICC profile are converted to sRGB (color_profile.h), at 16 bits before
/// rounding to 8. Pixels stay as stored, because cameras are calibrated on stored pixels; the EXIF
/// orientation is applied only if the stored width is the height of `expected`, and vice versa. Throws
/// Error(input) if the photo is truncated, corrupt or of a different size.
RgbaImage read_photo(const std::filesystem::path& file, PhotoSize expected);
/// Like read_photo(), but from the file's bytes. `file` is used in messages; unless it is a JPEG, it is also
/// read again.
RgbaImage decode_photo(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       PhotoSize expected);

/// A photo reduced to at most `longest` px on its longer side, and the size of a reduced pixel in original
/// pixels. A JPEG is reduced during decoding, which is several times faster. Throws whatever read_photo()
/// throws.
struct ReducedPhoto {
    RgbaImage image;
    std::array<double, 2> scale;
};
ReducedPhoto read_reduced_photo(const std::filesystem::path& file, PhotoSize expected, int longest);

/// Reads an image whose values are not colors, such as a mask: its color profile is ignored.
RgbaImage read_unprofiled(const std::filesystem::path& file, PhotoSize expected);

/// Whether these are the bytes of a JPEG of this size that decode_photo does not transpose.
bool is_upright_jpeg(std::span<const std::byte> bytes, PhotoSize size);

/// The message of an error about this file without the file's path, such as "JPEG is corrupt ...".
std::string reason_of(const Error& error, const std::filesystem::path& file);

}  // namespace vantage
