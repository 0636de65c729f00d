#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "base/values/rgba_image.h"
#include "pipeline/photos/color_profile.h"

namespace vantage {

/// Width and height in pixels.
struct PhotoSize {
    int width = 0, height = 0;
};

/// The contents of an image file's header.
struct PhotoHeader {
    PhotoSize size;        ///< as stored
    ProfileUse profile{};  ///< use of the ICC profile
    int orientation = 1;   ///< EXIF, 1 to 8
    /// Whether the file stores linear light (EXR, Radiance HDR), which becomes sRGB on reading.
    bool linear = false;
};

/// Type of a channel's values.
enum class Sample { u8, f32 };

/// Reads and writes image files with OpenImageIO. Loading OpenImageIO and its dependencies takes longer than
/// checking many packages, so this code is in a separate library, loaded on first use; plain JPEG files do
/// not need it. The functions throw Error(input) or Error(storage) naming the file.
struct ImageFiles {
    PhotoHeader (*header)(const std::filesystem::path& file);
    /// Colors with an ICC profile and linear light are converted to sRGB; values above 1 become 1.
    RgbaImage (*read)(const std::filesystem::path& file);
    /// Like `read`, but ignores profiles; for images whose values are not colors.
    RgbaImage (*read_unprofiled)(const std::filesystem::path& file);
    /// Writes interleaved pixels, top row first, in the format of the file's extension, which is PNG, EXR, or
    /// JPEG at quality 97 without chroma subsampling. Four channels are RGBA with straight alpha.
    void (*write)(const std::filesystem::path& file, int width, int height, int channels, Sample sample,
                  std::span<const std::byte> pixels);
};

/// Loads the library on the first call. Throws Error(usage) if the library cannot be loaded.
const ImageFiles& image_files();

}  // namespace vantage
