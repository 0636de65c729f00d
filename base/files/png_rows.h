#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace vantage {

/// A PNG picture that is written row by row, so that its size is not limited by memory: RGBA, 8 bits, sRGB.
/// Written to FILE.part-PID, which takes the name of the file at the end, and is removed if there is none.
class PngRows {
  public:
    static constexpr int max_pixels = 1'000'000;  ///< a side

    /// `xmp`: metadata for the file, an XMP packet; empty: none. Throws Error(storage) if the file cannot be
    /// written.
    PngRows(const std::filesystem::path& file, int width, int height, const std::string& xmp = "");
    ~PngRows();
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    /// The next row, four bytes per pixel. Throws Error(storage).
    void add(std::span<const std::uint8_t> row);
    /// After the last row. Throws Error(storage).
    void finish();

  private:
    struct State;
    [[noreturn]] void fail() const;
    std::unique_ptr<State> state_;
};

}  // namespace vantage
