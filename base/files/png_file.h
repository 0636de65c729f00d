#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

namespace vantage {

/// Writes RGBA pixels (8 bits, sRGB, straight alpha, top row first) as a PNG file, whatever the extension.
/// The file is written as FILE.part-RANDOM and then renamed. Throws Error(storage).
void write_png(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace vantage
