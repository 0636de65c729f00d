#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace vantage {

/// A PNG picture that is written row by row, so that its size is not limited by memory: RGBA, 8 bits, sRGB.
/// The picture is written to FILE.part-RANDOM, which is renamed at the end, or removed if the picture is not
/// finished.
class PngRows {
  public:
    static constexpr int max_pixels = 1'000'000;  ///< per side

    /// `xmp`: metadata as an XMP packet, or empty. Throws Error(storage) if the file cannot be written.
    PngRows(const std::filesystem::path& file, int width, int height, const std::string& xmp = "");
    ~PngRows();
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    /// Writes the next row, four bytes per pixel. Throws Error(storage).
    void add(std::span<const std::uint8_t> row);
    /// Completes the file after the last row. Throws Error(storage).
    void finish();

  private:
    struct State;
    [[noreturn]] void fail() const;
    std::unique_ptr<State> state_;
};

}  // namespace vantage
