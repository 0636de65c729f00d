#pragma once
#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace vantage {

/// Writes an image with OpenImageIO, in the format given by the file's extension; returns false on failure.
/// `pixels` are interleaved values of type `type`.
inline bool write_image_file(const std::filesystem::path& file, const OIIO::ImageSpec& spec,
                             OIIO::TypeDesc type, const void* pixels) {
    const auto out = OIIO::ImageOutput::create(file.string());
    return out && out->open(file.string(), spec) && out->write_image(type, pixels) && out->close();
}

}  // namespace vantage
