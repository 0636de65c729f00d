#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

namespace vantage {

/// Writes RGBA pixels (8 bits, sRGB, straight alpha, top row first) as a PNG to FILE.part-PID, which is then
/// renamed to the file, whatever its extension. Throws Error(storage).
void write_png(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace vantage
