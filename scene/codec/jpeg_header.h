#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vantage::codec {

/// What precedes the entropy-coded data of a baseline JPEG (ITU-T T.81, Annex B): tables, size and scan.
struct JpegHeader {
    std::size_t bytes = 0;     ///< up to and including the scan's header
    std::size_t frame_at = 0;  ///< where the frame's marker (SOF0) is
    int width = 0, height = 0;
    int mcu_width = 0, mcu_height = 0;  ///< pixels that are coded together, 8 to 32
    int restart_interval = 0;           ///< MCUs; 0: no restarts

    int mcu_columns() const { return (width + mcu_width - 1) / mcu_width; }
    int mcu_rows() const { return (height + mcu_height - 1) / mcu_height; }
};

/// Reads a header at the beginning of `jpeg`. Empty unless it is that of a baseline JPEG of 8 bits with one
/// scan of all its 1 or 3 components.
std::optional<JpegHeader> parse_jpeg_header(std::span<const std::byte> jpeg);

/// A marker of a header and what follows it, which begins with its own length of two bytes.
struct JpegSegment {
    std::size_t at;  ///< where the marker is
    int marker;
    std::span<const std::byte> content;
};
/// The segments between the start of the image and its data. `header` is what was parsed from `jpeg`.
std::vector<JpegSegment> segments_of(std::span<const std::byte> jpeg, const JpegHeader& header);

/// How coarsely a JPEG of any kind rounds luminance: the mean of its first table of quantization over that of
/// ITU-T T.81, Annex K, such as 0.24 at libjpeg's quality 88. 0 if there is no table.
double quantization_of(std::span<const std::byte> jpeg);

/// The header's bytes with another size, 1 to 65535 pixels along each side.
std::vector<std::byte> resized_header(std::span<const std::byte> jpeg, const JpegHeader& header, int width,
                                      int height);

}  // namespace vantage::codec
