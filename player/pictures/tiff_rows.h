#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "base/files/replace_file.h"

struct tiff;  // libtiff's TIFF

namespace vantage {

/// A TIFF picture that is written row by row, as with PngRows: RGBA, 8 bits, deflated; a BigTIFF if it could
/// exceed 4 GiB. Its position on the plane is in GeoTIFF tags (OGC 19-008r4, user-defined model, pixels are
/// areas).
class TiffRows {
  public:
    /// `upper_left`: corner of the picture, in the plane's coordinates; `resolution`: units per pixel. Throws
    /// Error(storage) if the file cannot be written.
    TiffRows(const std::filesystem::path& file, int width, int height, const Eigen::Vector2d& upper_left,
             double resolution);

    /// Adds the next row, four bytes per pixel. Throws Error(storage).
    void add(std::span<const std::uint8_t> row);
    /// Completes the file after the last row. Throws Error(storage).
    void finish();

  private:
    [[noreturn]] void fail() const;

    UnfinishedFile file_;
    std::unique_ptr<tiff, void (*)(tiff*)> tiff_;
    std::uint32_t row_ = 0;
    std::vector<std::uint8_t> pixels_;  ///< copy of a row, since libtiff's predictor modifies its input
};

}  // namespace vantage
