#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "pipeline/pixels/rgba_image.h"

namespace vantage {

/// Width and height in pixels.
struct PhotoSize {
    int width = 0, height = 0;
};

/// The contents of an image file's header.
struct PhotoHeader {
    PhotoSize size;       ///< as stored
    std::string profile;  ///< description of the ICC profile; empty if there is none or it is sRGB
    int orientation = 1;  ///< EXIF, 1 to 8
};

/// Type of a channel's values.
enum class Sample { u8, f32 };

/// Reading and writing of image files by OpenImageIO. With its dependencies, OpenImageIO takes longer to load
/// than many packages take to check, so it is in a library of its own, which is loaded on first use: a plain
/// JPEG does not need it. The functions throw Error(input) or Error(storage) naming the file.
struct ImageFiles {
    PhotoHeader (*header)(const std::filesystem::path& file);
    RgbaImage (*read)(const std::filesystem::path& file);
    /// Writes interleaved pixels, top row first, in the format of the file's extension: PNG, EXR, or JPEG at
    /// quality 97 without chroma subsampling. Four channels are RGBA with straight alpha.
    void (*write)(const std::filesystem::path& file, int width, int height, int channels, Sample sample,
                  std::span<const std::byte> pixels);
};

/// Loads the library on the first call. Throws Error(usage) if it cannot be loaded.
const ImageFiles& image_files();

}  // namespace vantage
