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

/// What an image file's header says.
struct PhotoHeader {
    PhotoSize size;       ///< as stored
    std::string profile;  ///< description of its ICC profile, empty where it has none or it is sRGB
    int orientation = 1;  ///< EXIF, 1 to 8
};

enum class Sample { u8, f32 };

/// Image files of all kinds, by OpenImageIO. With all that it links it takes longer to load than many a
/// package to check, so it is a library of its own, loaded when something other than a JPEG is first met.
/// Functions throw Error(input) or Error(storage) naming the file.
struct ImageFiles {
    PhotoHeader (*header)(const std::filesystem::path& file);
    RgbaImage (*read)(const std::filesystem::path& file);
    /// Interleaved pixels, rows from the top, in the format that the extension names (PNG, EXR, JPEG at
    /// quality 97 with full colour resolution). Four channels are straight RGBA.
    void (*write)(const std::filesystem::path& file, int width, int height, int channels, Sample sample,
                  std::span<const std::byte> pixels);
};
/// Throws Error(usage) where the library is not beside the program.
const ImageFiles& image_files();

}  // namespace vantage
