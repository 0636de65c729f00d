#pragma once
#include <OpenImageIO/typedesc.h>

#include <filesystem>
#include <span>

namespace vantage {

/// Writes interleaved pixels, rows from the top, in the format that the extension names (PNG, EXR, JPEG at
/// quality 97 with full colour resolution). Four channels are straight RGBA. Throws Error(storage).
void write_image(const std::filesystem::path& file, int width, int height, int channels, OIIO::TypeDesc type,
                 std::span<const std::byte> pixels);

}  // namespace vantage
