#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vantage::codec {

/// The header of a baseline JPEG (ITU-T T.81, Annex B), which precedes the entropy-coded data: tables, size
/// and scan.
struct JpegHeader {
    std::size_t bytes = 0;     ///< up to and including the scan's header
    std::size_t frame_at = 0;  ///< offset of the frame's marker (SOF0)
    int width = 0, height = 0;
    int mcu_width = 0, mcu_height = 0;  ///< pixels, 8 to 32
    int restart_interval = 0;           ///< MCUs; 0: no restarts

    int mcu_columns() const { return (width + mcu_width - 1) / mcu_width; }
    int mcu_rows() const { return (height + mcu_height - 1) / mcu_height; }
};

/// Parses the header at the beginning of `jpeg`. Empty unless `jpeg` is an 8-bit baseline JPEG with 1 or 3
/// components, all of them in one scan.
std::optional<JpegHeader> parse_jpeg_header(std::span<const std::byte> jpeg);

/// A marker in a header and its segment, which begins with its own length in two bytes.
struct JpegSegment {
    std::size_t at;  ///< offset of the marker
    int marker;
    std::span<const std::byte> content;
};
/// The segments between the start of the image and its data. `header`: the header parsed from `jpeg`.
std::vector<JpegSegment> segments_of(std::span<const std::byte> jpeg, const JpegHeader& header);

/// How coarsely a JPEG of any kind quantizes luminance: the mean of its first quantization table divided by
/// the mean of the table in ITU-T T.81, Annex K. The value is, for example, 0.24 for libjpeg's quality 88,
/// and 0 if there is no table.
double quantization_of(std::span<const std::byte> jpeg);

/// The header's bytes with a different size, 1 to 65535 pixels along each side.
std::vector<std::byte> resized_header(std::span<const std::byte> jpeg, const JpegHeader& header, int width,
                                      int height);

}  // namespace vantage::codec
