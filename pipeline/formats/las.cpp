#include "pipeline/formats/las.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>

#include "base/text/error.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Rgb = std::array<std::uint16_t, 3>;

/// The layout of a point format, in bytes.
struct PointFormat {
    unsigned length;  ///< minimum length of a record
    int color;        ///< -1: none
};
constexpr std::array<PointFormat, 11> point_formats{{{20, -1},
                                                     {28, -1},
                                                     {26, 20},
                                                     {34, 28},
                                                     {57, -1},
                                                     {63, 28},
                                                     {30, -1},
                                                     {36, 30},
                                                     {38, 30},
                                                     {59, -1},
                                                     {67, 30}}};
constexpr std::size_t intensity_at = 12, flags_at = 15;

template <class T>
T value_at(const std::byte* bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes + at, sizeof value);
    return value;
}

struct Header {
    unsigned format;
    std::size_t record;  ///< bytes
    std::uint64_t points, first;
    Eigen::Vector3d scale, offset;
};

Error wrong(const fs::path& file, const std::string& what) {
    return Error(Exit::input, file.string() + ": " + what);
}

/// Versions before 1.4 count points in 32 bits.
std::uint64_t point_count(const std::vector<std::byte>& h) {
    constexpr std::size_t wide_count_at = 247, length_1_4 = 375;
    const bool wide = value_at<std::uint8_t>(h.data(), 25) >= 4 && h.size() >= length_1_4;
    const std::uint64_t count = wide ? value_at<std::uint64_t>(h.data(), wide_count_at) : 0;
    return count ? count : value_at<std::uint32_t>(h.data(), 107);
}

Header read_header(const fs::path& file) {
    constexpr std::size_t shortest = 227, longest = 375;
    const std::vector<std::byte> h = read_file(file, longest);
    if (h.size() < 4 || std::memcmp(h.data(), "LASF", 4) != 0)
        throw wrong(file, "is not a LAS file: expected LASF at its beginning");
    if (h.size() < shortest) throw wrong(file, "is cut off in its header");
    const unsigned major = value_at<std::uint8_t>(h.data(), 24),
                   format = value_at<std::uint8_t>(h.data(), 104);
    if (major != 1) throw wrong(file, "LAS version " + std::to_string(major) + ", expected 1");
    if (format & 0xc0)
        throw wrong(file,
                    "is compressed (LAZ), which is not supported; expected LAS ('laszip' or 'pdal "
                    "translate' can convert it)");
    if (format >= point_formats.size())
        throw wrong(file, "point format " + std::to_string(format) + ", expected 0 to 10");
    Header out{format,
               value_at<std::uint16_t>(h.data(), 105),
               point_count(h),
               value_at<std::uint32_t>(h.data(), 96),
               {},
               {}};
    if (out.record < point_formats[format].length)
        throw wrong(file, "points of " + std::to_string(out.record) + " bytes, expected at least " +
                              std::to_string(point_formats[format].length) + " in format " +
                              std::to_string(format));
    if (out.first < shortest) throw wrong(file, "points begin inside the header");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out.scale[Eigen::Index(axis)] = value_at<double>(h.data(), 131 + 8 * axis);
        out.offset[Eigen::Index(axis)] = value_at<double>(h.data(), 155 + 8 * axis);
    }
    if (!out.scale.allFinite() || !out.offset.allFinite() || (out.scale.array() == 0).any())
        throw wrong(file, "the scale or offset of its coordinates is zero or not finite");
    return out;
}

/// Throws if the file holds fewer points than its header states.
void expect_points(const fs::path& file, const Header& h) {
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    if (h.points == 0) throw wrong(file, "has no points");
    if (h.points > most)
        throw wrong(file, std::to_string(h.points) + " points, expected at most " + std::to_string(most));
    const std::uint64_t bytes = fs::file_size(file),
                        there = bytes > h.first ? (bytes - h.first) / h.record : 0;
    if (there < h.points)
        throw wrong(file, "is cut off: its header says " + std::to_string(h.points) +
                              " points, but the file has " + std::to_string(there));
}

bool withheld(unsigned format, std::uint8_t flags) { return flags & (format < 6 ? 0x80 : 0x04); }

std::uint8_t byte_of(double share) { return std::uint8_t(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

std::uint16_t largest_of(const std::vector<Rgb>& colors) {
    std::uint16_t most = 0;
    for (const Rgb& c : colors) most = std::max({most, c[0], c[1], c[2]});
    return most;
}

void take_colors(const std::vector<Rgb>& colors, std::uint16_t most, Mesh& out) {
    const double white = most > 255 ? 65535 : 255;
    for (const Rgb& c : colors)
        out.colors.push_back({byte_of(c[0] / white), byte_of(c[1] / white), byte_of(c[2] / white), 255});
}

/// Adds the intensities as grays, unless all of them are 0.
void take_intensities(const std::vector<std::uint16_t>& intensities, Mesh& out) {
    std::vector<std::uint16_t> sorted = intensities;
    const auto bright = sorted.begin() + std::ptrdiff_t(sorted.size() * 99 / 100);
    std::nth_element(sorted.begin(), bright, sorted.end());
    const double white = *bright > 0 ? *bright : *std::ranges::max_element(sorted);
    if (!(white > 0)) return;
    for (const std::uint16_t i : intensities) {
        const std::uint8_t gray = byte_of(i / white);
        out.colors.push_back({gray, gray, gray, 255});
    }
}

/// The contents of the records, one per point.
struct Points {
    Mesh mesh;
    std::vector<Rgb> colors;
    std::vector<std::uint16_t> intensities;
    std::size_t withheld = 0;
};

void take_point(const Header& h, const std::byte* record, Points& out) {
    if (withheld(h.format, value_at<std::uint8_t>(record, flags_at))) {
        ++out.withheld;
        return;
    }
    Eigen::Vector3d p;
    for (std::size_t axis = 0; axis < 3; ++axis)
        p[Eigen::Index(axis)] = value_at<std::int32_t>(record, 4 * axis);
    out.mesh.positions.emplace_back(p.cwiseProduct(h.scale) + h.offset);
    if (const int at = point_formats[h.format].color; at >= 0)
        out.colors.push_back(value_at<Rgb>(record, std::size_t(at)));
    else
        out.intensities.push_back(value_at<std::uint16_t>(record, intensity_at));
}

Points read_points(const fs::path& file, const Header& h) {
    std::ifstream in(file, std::ios::binary);
    in.seekg(std::streamoff(h.first));
    constexpr std::uint64_t batch = 65536;
    std::vector<std::byte> records(std::size_t(std::min(batch, h.points) * h.record));
    Points out;
    for (std::uint64_t done = 0; done < h.points; done += batch) {
        const auto now = std::size_t(std::min(batch, h.points - done));
        in.read(reinterpret_cast<char*>(records.data()), std::streamsize(now * h.record));
        if (!in) throw UnreadableFile(file.string() + ": cannot be read");
        for (std::size_t i = 0; i < now; ++i) take_point(h, &records[i * h.record], out);
    }
    return out;
}

}  // namespace

Mesh read_las(const fs::path& file, std::vector<std::string>& warnings) {
    if (!fs::exists(file)) throw Error(Exit::input, file.string() + ": does not exist");
    const Header h = read_header(file);
    expect_points(file, h);
    Points points = read_points(file, h);
    if (points.withheld > 0)
        warnings.push_back(file.filename().string() + ": " + std::to_string(points.withheld) +
                           (points.withheld == 1 ? " point" : " points") + " marked as withheld dropped");
    if (points.mesh.positions.empty()) throw wrong(file, "has no points that are not withheld");
    if (const std::uint16_t most = largest_of(points.colors); most > 0)
        take_colors(points.colors, most, points.mesh);
    else if (!points.intensities.empty())
        take_intensities(points.intensities, points.mesh);
    return std::move(points.mesh);
}

}  // namespace vantage
