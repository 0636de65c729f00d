#include "scene/codec/jpeg_header.h"

#include <algorithm>

#include "scene/codec/jpeg_bytes.h"

namespace vantage::codec {
namespace {

constexpr int start_of_image = 0xd8, baseline_frame = 0xc0, arithmetic_tables = 0xcc, restart_marker = 0xdd,
              start_of_scan = 0xda;

/// Reads the header of a frame; `segment` begins with its length. Returns false if this kind of frame is not
/// supported.
bool read_frame(std::span<const std::byte> segment, JpegHeader& out) {
    if (segment.size() < 8 || byte_at(segment, 2) != 8) return false;
    out.height = word_at(segment, 3);
    out.width = word_at(segment, 5);
    const auto components = std::size_t(byte_at(segment, 7));
    if ((components != 1 && components != 3) || segment.size() != 8 + 3 * components) return false;
    int h = 1, v = 1;
    for (std::size_t c = 0; c < components; ++c) {
        const int sampling = byte_at(segment, 8 + 3 * c + 1);
        if (sampling >> 4 < 1 || sampling >> 4 > 4 || (sampling & 15) < 1 || (sampling & 15) > 4)
            return false;
        h = std::max(h, sampling >> 4);
        v = std::max(v, sampling & 15);
    }
    // The blocks of a single component are coded one by one, whatever its sampling factors are (A.2.2).
    out.mcu_width = components == 1 ? 8 : 8 * h;
    out.mcu_height = components == 1 ? 8 : 8 * v;
    return out.width > 0 && out.height > 0;
}

bool is_other_frame(int marker) {
    return marker >= 0xc1 && marker <= 0xcf && marker != huffman_tables && marker != arithmetic_tables;
}

/// The segment whose marker is at `at`; empty if it is incomplete.
std::optional<JpegSegment> segment_at(std::span<const std::byte> jpeg, std::size_t at) {
    if (at + 4 > jpeg.size() || byte_at(jpeg, at) != 0xff) return std::nullopt;
    const auto length = std::size_t(word_at(jpeg, at + 2));
    if (length < 2 || length > jpeg.size() - at - 2) return std::nullopt;
    return JpegSegment{at, byte_at(jpeg, at + 1), jpeg.subspan(at + 2, length)};
}

std::size_t end_of(const JpegSegment& s) { return s.at + 2 + s.content.size(); }

}  // namespace

std::optional<JpegHeader> parse_jpeg_header(std::span<const std::byte> jpeg) {
    if (jpeg.size() < 2 || word_at(jpeg, 0) != (0xff00 | start_of_image)) return std::nullopt;
    JpegHeader out;
    std::size_t at = 2;
    while (const auto segment = segment_at(jpeg, at)) {
        const auto& [from, marker, content] = *segment;
        if (marker < baseline_frame || is_other_frame(marker)) return std::nullopt;
        if (marker == baseline_frame) {
            if (out.frame_at || !read_frame(content, out)) return std::nullopt;
            out.frame_at = from;
        }
        if (marker == restart_marker) {
            if (content.size() != 4) return std::nullopt;
            out.restart_interval = word_at(content, 2);
        }
        at = end_of(*segment);
        if (marker != start_of_scan) continue;
        out.bytes = at;
        const bool all =
            out.frame_at && content.size() >= 3 && byte_at(content, 2) == byte_at(jpeg, out.frame_at + 9);
        return all ? std::optional(out) : std::nullopt;
    }
    return std::nullopt;
}

std::vector<JpegSegment> segments_of(std::span<const std::byte> jpeg, const JpegHeader& header) {
    std::vector<JpegSegment> out;
    for (std::size_t at = 2; at < header.bytes; at = end_of(out.back()))
        out.push_back(segment_at(jpeg, at).value());
    return out;
}

double quantization_of(std::span<const std::byte> jpeg) {
    constexpr int tables = 0xdb;
    constexpr double mean_of_annex_k = 57.625;
    std::size_t at = 2;
    while (const auto segment = segment_at(jpeg, at)) {
        const auto& [from, marker, content] = *segment;
        if (marker == start_of_scan) break;
        at = end_of(*segment);
        if (marker != tables || content.size() < 3 || (byte_at(content, 2) & 15) != 0) continue;
        const bool words = byte_at(content, 2) >> 4;
        if (content.size() < 3 + (words ? 128 : 64)) break;
        double sum = 0;
        for (std::size_t i = 0; i < 64; ++i)
            sum += words ? word_at(content, 3 + 2 * i) : byte_at(content, 3 + i);
        return sum / 64 / mean_of_annex_k;
    }
    return 0;
}

std::vector<std::byte> resized_header(std::span<const std::byte> jpeg, const JpegHeader& header, int width,
                                      int height) {
    std::vector<std::byte> out(jpeg.begin(), jpeg.begin() + std::ptrdiff_t(header.bytes));
    const auto set = [&](std::size_t at, int value) {
        out[at] = std::byte(value >> 8);
        out[at + 1] = std::byte(value & 0xff);
    };
    set(header.frame_at + 5, height);
    set(header.frame_at + 7, width);
    return out;
}

}  // namespace vantage::codec
