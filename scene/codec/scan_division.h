#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "scene/codec/jpeg_header.h"

namespace vantage::codec {

/// The entropy-coded data of a scan, divided into segments of `interval` MCUs, row by row; segment i ends at
/// ends[i].
struct DividedScan {
    std::vector<std::byte> bytes{};
    std::vector<std::byte> tables{};  ///< a DHT segment to add to the header; empty if none is needed
    std::vector<std::size_t> ends{};
};

/// Divides the scan of a baseline JPEG (Huffman codes, ITU-T T.81, Annex F) by copying its codes: only the DC
/// differences at the beginning of segments change. Copying takes a tenth of the time that decoding and
/// re-encoding the coefficients takes. `interval` must divide the number of MCUs in a row. If the photo's own
/// table lacks codes for the differences that begin segments, all DC differences are encoded with the table
/// of Annex K. Empty if the data is damaged, or if there is more than one scan.
std::optional<DividedScan> divide_scan(std::span<const std::byte> jpeg, const JpegHeader& header,
                                       int interval);

}  // namespace vantage::codec
