#pragma once
#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace vantage {

/// Writes an image in the format of the file's extension with OpenImageIO; false if it cannot be written.
/// `pixels` are interleaved values of this type.
inline bool write_image_file(const std::filesystem::path& file, const OIIO::ImageSpec& spec,
                             OIIO::TypeDesc type, const void* pixels) {
    const auto out = OIIO::ImageOutput::create(file.string());
    return out && out->open(file.string(), spec) && out->write_image(type, pixels) && out->close();
}

}  // namespace vantage
