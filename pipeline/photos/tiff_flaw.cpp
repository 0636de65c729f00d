#include "pipeline/photos/tiff_flaw.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <numeric>
#include <vector>

namespace vantage {
namespace {

/// Tags (TIFF 6.0, sections 8 and 15).
enum Tag : unsigned {
    width = 256,
    height = 257,
    bits_per_sample = 258,
    compression = 259,
    strip_offsets = 273,
    samples_per_pixel = 277,
    strip_bytes = 279,
    color_map = 320,
    tile_offsets = 324,
    tile_bytes = 325
};

using Values = std::vector<std::uint64_t>;

/// The values of the first directory's tags that are whole numbers.
class Directory {
  public:
    explicit Directory(const std::filesystem::path& file) : in_(file, std::ios::binary) {
        big_ = in_.get() == 'M';
        in_.get();
        wide_ = number(2) == 43;  // BigTIFF
        if (wide_) number(4);
        in_.seekg(std::streamoff(number(wide_ ? 8 : 4)));
        const std::uint64_t entries = number(wide_ ? 8 : 2);
        for (std::uint64_t i = 0; in_ && i < entries; ++i) read_entry();
    }
    /// Whether the whole directory is in the file.
    bool whole() const { return bool(in_); }
    const Values* find(Tag tag) const {
        const auto found = values_.find(tag);
        return found == values_.end() || found->second.empty() ? nullptr : &found->second;
    }
    std::uint64_t value(Tag tag, std::uint64_t otherwise) const {
        const Values* found = find(tag);
        return found ? found->front() : otherwise;
    }

  private:
    std::uint64_t number(std::size_t bytes) {
        std::array<unsigned char, 8> b{};
        in_.read(reinterpret_cast<char*>(b.data()), std::streamsize(bytes));
        std::uint64_t out = 0;
        for (std::size_t i = 0; i < bytes; ++i) out |= std::uint64_t(b[big_ ? bytes - 1 - i : i]) << (8 * i);
        return out;
    }
    void read_entry() {
        constexpr std::uint64_t max_values = 1 << 24;
        const auto tag = unsigned(number(2)), type = unsigned(number(2));
        const std::uint64_t count = number(wide_ ? 8 : 4);
        const std::streamoff next = std::streamoff(in_.tellg()) + (wide_ ? 8 : 4);
        const std::size_t size = type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
        if (size && count <= max_values) {
            if (size * count > (wide_ ? 8u : 4u)) in_.seekg(std::streamoff(number(wide_ ? 8 : 4)));
            Values& values = values_[tag];
            while (in_ && values.size() < count) values.push_back(number(size));
        }
        if (in_) in_.seekg(next);
    }

    std::ifstream in_;
    bool big_ = false, wide_ = false;
    std::map<unsigned, Values> values_;
};

/// Whether the parts of the picture are within the file.
bool within(const Values& offsets, const Values& bytes, std::uint64_t size) {
    for (std::size_t i = 0; i < std::min(offsets.size(), bytes.size()); ++i)
        if (offsets[i] > size || bytes[i] > size - offsets[i]) return false;
    return true;
}

/// Whether the byte counts are those of uncompressed strips; some programs write larger ones.
bool exact_counts(const Directory& tiff, const Values& bytes) {
    const Values* bits = tiff.find(bits_per_sample);
    const std::uint64_t per_pixel =
        (bits && bits->size() > 1 ? std::reduce(bits->begin(), bits->end())
                                  : tiff.value(bits_per_sample, 1) * tiff.value(samples_per_pixel, 1));
    const std::uint64_t rows = tiff.value(height, 0);
    return std::reduce(bytes.begin(), bytes.end()) <= rows * ((tiff.value(width, 0) * per_pixel + 7) / 8 + 8);
}

}  // namespace

std::string tiff_flaw(const std::filesystem::path& file) {
    const Directory tiff(file);
    if (!tiff.whole()) return "is cut off or damaged";
    if (!tiff.find(bits_per_sample)) return "its pixels have one bit, expected a TIFF of 8 or 16 bits";
    if (const Values* map = tiff.find(color_map);
        map && std::ranges::max(*map) < 256 && std::ranges::max(*map) > 0)
        return "its color map has 8 bits, expected 16";
    const bool tiled = tiff.find(tile_offsets);
    const Values *offsets = tiff.find(tiled ? tile_offsets : strip_offsets),
                 *bytes = tiff.find(tiled ? tile_bytes : strip_bytes);
    if (!offsets || !bytes || (!tiled && tiff.value(compression, 1) == 1 && !exact_counts(tiff, *bytes)))
        return "";
    return within(*offsets, *bytes, std::filesystem::file_size(file))
               ? ""
               : "is cut off: the file ends before its pixels";
}

}  // namespace vantage
