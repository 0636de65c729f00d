#include "scene/codec/scan_division.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "scene/codec/jpeg_bytes.h"

namespace vantage::codec {
namespace {

constexpr int end_of_image = 0xd9, first_restart = 0xd0;
constexpr int max_blocks = 10;  ///< blocks per MCU (B.2.3)
constexpr int max_size = 11;    ///< bits of a DC difference
constexpr int peek_bits = 10;   ///< codes up to this length are found by one table lookup

/// A Huffman table (C.2), for encoding and decoding.
struct HuffmanTable {
    struct Code {
        std::uint16_t bits = 0;
        std::uint8_t length = 0;  ///< 0: the symbol has no code
    };
    struct Found {
        std::uint8_t symbol = 0, length = 0;
    };
    std::array<Code, 256> code_of{};
    std::array<Found, std::size_t(1) << peek_bits> short_codes{};
    std::array<std::int32_t, 18>
        end{};  ///< per length: one past the last code of that length, left-aligned to 16 bits
    std::array<std::int32_t, 17>
        first{};  ///< per length: the first code of that length minus the index of its symbol
    std::vector<std::uint8_t> symbols;
    bool defined = false;
};

/// Fills the table. `counts`: the number of codes of each length from 1 to 16. Returns false if there are
/// more codes than the lengths permit.
bool fill(HuffmanTable& t, std::span<const std::byte> counts, std::span<const std::byte> symbols) {
    t = {};
    for (const std::byte s : symbols) t.symbols.push_back(std::to_integer<std::uint8_t>(s));
    std::int32_t code = 0;
    std::size_t place = 0;
    for (int length = 1; length <= 16; ++length, code <<= 1) {
        t.first[std::size_t(length)] = code - std::int32_t(place);
        for (int i = 0; i < byte_at(counts, std::size_t(length) - 1); ++i, ++code, ++place) {
            if (code >= 1 << length || place >= t.symbols.size()) return false;
            const std::uint8_t symbol = t.symbols[place];
            t.code_of[symbol] = {std::uint16_t(code), std::uint8_t(length)};
            if (length > peek_bits) continue;
            const auto low = std::size_t(code) << (peek_bits - length);
            std::fill_n(t.short_codes.begin() + std::ptrdiff_t(low), std::size_t(1) << (peek_bits - length),
                        HuffmanTable::Found{symbol, std::uint8_t(length)});
        }
        t.end[std::size_t(length)] = code << (16 - length);
    }
    t.end[17] = 1 << 17;  // ends the search
    t.defined = place == t.symbols.size();
    return t.defined;
}

/// Whether one of the four bytes is 0xff.
bool has_marker_byte(std::uint32_t w) { return ((w & 0x7f7f7f7fu) + 0x01010101u) & w & 0x80808080u; }

/// Reads entropy-coded data, most significant bit first, and omits the zeros stuffed after 0xff. After a
/// marker or the end, the reader supplies zeros.
class BitReader {
  public:
    explicit BitReader(std::span<const std::byte> data) : data_(data) {}

    /// The next 32 bits, without consuming them.
    std::uint32_t peek() {
        if (held_ < 32) refill();
        return std::uint32_t(bits_ >> 32);
    }
    void skip(int n) {
        bits_ <<= n;
        held_ -= n;
    }
    /// Whether more bits were consumed than were available.
    bool overrun() const { return held_ < 0 || beyond_ > held_; }
    /// Skips the rest of the byte and the restart marker, which must come next.
    bool restart() {
        held_ = beyond_ = 0;
        bits_ = 0;
        // Any bits that were read ahead are padding, because reading stops at markers.
        while (at_ < data_.size() && data_[at_] == std::byte(0xff) && at_ + 1 < data_.size() &&
               data_[at_ + 1] == std::byte(0xff))
            ++at_;
        if (at_ + 1 >= data_.size() || data_[at_] != std::byte(0xff) ||
            (byte_at(data_, at_ + 1) & 0xf8) != first_restart)
            return false;
        at_ += 2;
        return true;
    }
    /// Whether the image ends here.
    bool at_end() const {
        return at_ + 1 < data_.size() && data_[at_] == std::byte(0xff) &&
               byte_at(data_, at_ + 1) == end_of_image;
    }

  private:
    void refill() {
        if (data_.size() - at_ >= 4 && held_ <= 32) {
            std::uint32_t word;
            std::memcpy(&word, &data_[at_], sizeof word);
            if (!has_marker_byte(word)) {
                bits_ |= std::uint64_t(__builtin_bswap32(word)) << (32 - held_);
                held_ += 32;
                at_ += 4;
                return;
            }
        }
        while (held_ <= 56) {
            std::uint64_t next = 0;
            if (at_ >= data_.size()) {
                beyond_ += 8;
            } else if (data_[at_] != std::byte(0xff)) {
                next = std::to_integer<std::uint64_t>(data_[at_++]);
            } else if (at_ + 1 < data_.size() && data_[at_ + 1] == std::byte(0)) {
                next = 0xff;
                at_ += 2;
            } else {
                beyond_ += 8;
            }
            bits_ |= next << (56 - held_);
            held_ += 8;
        }
    }

    std::span<const std::byte> data_;
    std::size_t at_ = 0;
    std::uint64_t bits_ = 0;
    int held_ = 0, beyond_ = 0;  ///< the number of bits held, and how many of them are beyond the data
};

/// Writes bits, stuffing a zero after every 0xff byte.
class BitWriter {
  public:
    /// An upper bound on the bytes of an MCU: 64 codes of at most 31 bits per block, with a stuffed zero
    /// after every byte.
    static constexpr std::size_t room = std::size_t(max_blocks) * 64 * 8;

    explicit BitWriter(std::size_t expected) : out_(expected + room) {}
    /// Makes room for an MCU. The function must be called before each MCU.
    void make_room() {
        if (out_.size() - at_ < room) out_.resize(2 * out_.size());
    }
    /// Writes `n` bits, at most 32.
    void put(std::uint32_t bits, int n) {
        bits_ = bits_ << n | bits;
        held_ += n;
        if (held_ < 32) return;
        held_ -= 32;
        const auto word = std::uint32_t(bits_ >> held_);
        if (has_marker_byte(word)) {
            for (int shift = 24; shift >= 0; shift -= 8) put_byte(std::byte(word >> shift & 0xff));
        } else {
            for (int i = 0; i < 4; ++i) out_[at_ + std::size_t(i)] = std::byte(word >> (24 - 8 * i) & 0xff);
            at_ += 4;
        }
    }
    /// Fills the last byte with ones.
    void finish() {
        const int padding = (8 - held_ % 8) % 8;
        bits_ = bits_ << padding | ((1u << padding) - 1);
        for (held_ += padding; held_ > 0; held_ -= 8) put_byte(std::byte(bits_ >> (held_ - 8) & 0xff));
        bits_ = 0;
    }
    std::size_t size() const { return at_; }
    std::vector<std::byte> take() {
        out_.resize(at_);
        return std::move(out_);
    }

  private:
    void put_byte(std::byte b) {
        out_[at_++] = b;
        if (b == std::byte(0xff)) out_[at_++] = std::byte(0);
    }

    std::vector<std::byte> out_;
    std::size_t at_ = 0;
    std::uint64_t bits_ = 0;
    int held_ = 0;
};

struct Component {
    int id = 0, blocks = 1;  ///< blocks per MCU
    const HuffmanTable *dc = nullptr, *ac = nullptr, *dc_out = nullptr;
    int in = 0, out = 0;  ///< the previous DC value in the input and in the output
};

struct Scan {
    std::array<HuffmanTable, 4> dc, ac;
    HuffmanTable standard_dc;
    std::vector<Component> components;
    int restart_interval = 0;
};

/// Reads Huffman tables. `segment` begins with its length, as in the functions below.
bool read_tables(std::span<const std::byte> segment, Scan& out) {
    for (std::size_t at = 2; at < segment.size();) {
        if (segment.size() - at < 17) return false;
        const int which = byte_at(segment, at);
        const auto counts = segment.subspan(at + 1, 16);
        std::size_t n = 0;
        for (const std::byte c : counts) n += std::to_integer<std::size_t>(c);
        at += 17;
        if ((which & 0xee) != 0 && (which & 0xec) != 0) return false;
        if (n > 256 || n > segment.size() - at) return false;
        HuffmanTable& table = (which >> 4 ? out.ac : out.dc)[std::size_t(which & 3)];
        if (!fill(table, counts, segment.subspan(at, n))) return false;
        at += n;
    }
    return true;
}

void read_frame(std::span<const std::byte> segment, Scan& out) {
    const bool single = byte_at(segment, 7) == 1;
    for (std::size_t at = 8; at + 3 <= segment.size(); at += 3) {
        const int sampling = byte_at(segment, at + 1);
        out.components.push_back(
            {.id = byte_at(segment, at), .blocks = single ? 1 : (sampling >> 4) * (sampling & 15)});
    }
}

bool read_scan(std::span<const std::byte> segment, Scan& out) {
    int blocks = 0;
    for (const Component& c : out.components) blocks += c.blocks;
    if (blocks > max_blocks) return false;
    const auto n = std::size_t(byte_at(segment, 2));
    if (n != out.components.size() || segment.size() != 6 + 2 * n) return false;
    for (std::size_t c = 0; c < n; ++c) {
        const int tables = byte_at(segment, 4 + 2 * c);
        if (byte_at(segment, 3 + 2 * c) != out.components[c].id || (tables & 0xcc) != 0) return false;
        out.components[c].dc = &out.dc[std::size_t(tables >> 4)];
        out.components[c].ac = &out.ac[std::size_t(tables & 3)];
        if (!out.components[c].dc->defined || !out.components[c].ac->defined) return false;
    }
    return true;
}

/// Reads the tables and components; `header` has already been parsed.
bool read_header(std::span<const std::byte> jpeg, const JpegHeader& header, Scan& out) {
    out.restart_interval = header.restart_interval;
    const auto segments = segments_of(jpeg, header);
    for (const JpegSegment& s : segments) {
        if (s.marker == huffman_tables && !read_tables(s.content, out)) return false;
        if (s.at == header.frame_at) read_frame(s.content, out);
    }
    return read_scan(segments.back().content, out);
}

/// The codes of luminance differences (table K.3), as they follow the table's number in a DHT segment.
constexpr std::array<std::uint8_t, 28> standard_codes{0, 1, 5, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0,  0,
                                                      0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

bool has_all_sizes(const HuffmanTable& t) {
    return std::all_of(t.code_of.begin(), t.code_of.begin() + max_size + 1,
                       [](const auto& c) { return c.length > 0; });
}

/// Selects the codes to write. Returns the segment that defines these codes; empty if the header already
/// defines them.
std::vector<std::byte> choose_codes(Scan& scan) {
    const bool own =
        std::ranges::all_of(scan.components, [](const Component& c) { return has_all_sizes(*c.dc); });
    const auto codes = std::as_bytes(std::span(standard_codes));
    fill(scan.standard_dc, codes.first(16), codes.subspan(16));
    for (Component& c : scan.components) c.dc_out = own ? c.dc : &scan.standard_dc;
    if (own) return {};
    std::vector<std::byte> out{std::byte(0xff), std::byte(huffman_tables), std::byte(0), std::byte(0)};
    for (std::size_t id = 0; id < scan.dc.size(); ++id) {
        if (!scan.dc[id].defined) continue;
        out.push_back(std::byte(id));
        out.insert(out.end(), codes.begin(), codes.end());
    }
    out[3] = std::byte(out.size() - 2);
    return out;
}

/// Reads a code. The length is 0 if the code is invalid.
HuffmanTable::Found take(BitReader& in, const HuffmanTable& t) {
    const std::uint32_t next = in.peek();
    const HuffmanTable::Found found = t.short_codes[next >> (32 - peek_bits)];
    if (found.length) return found;
    const auto code = std::int32_t(next >> 16);
    int length = peek_bits + 1;
    while (code >= t.end[std::size_t(length)]) ++length;
    if (length > 16) return {};
    const std::int32_t place = (code >> (16 - length)) - t.first[std::size_t(length)];
    if (place < 0 || std::size_t(place) >= t.symbols.size()) return {};
    return {t.symbols[std::size_t(place)], std::uint8_t(length)};
}

/// The value of a difference, decoded from its extra bits (F.2.2.1).
int extended(std::uint32_t bits, int size) {
    return size == 0 || bits >> (size - 1) ? int(bits) : int(bits) - (1 << size) + 1;
}

bool put_difference(BitWriter& out, const HuffmanTable& t, int difference) {
    const int size = std::bit_width(std::uint32_t(difference < 0 ? -difference : difference));
    if (size > max_size) return false;  // not a difference of 8-bit samples
    const HuffmanTable::Code code = t.code_of[std::size_t(size)];
    const auto extra = std::uint32_t(difference < 0 ? difference + (1 << size) - 1 : difference);
    out.put(code.bits, code.length);
    if (size) out.put(extra, size);
    return true;
}

bool copy_block(BitReader& in, BitWriter& out, Component& c) {
    const HuffmanTable::Found dc = take(in, *c.dc);
    if (!dc.length || dc.symbol > 15) return false;
    in.skip(dc.length);
    if (dc.symbol) {
        c.in += extended(in.peek() >> (32 - dc.symbol), dc.symbol);
        in.skip(dc.symbol);
    }
    if (!put_difference(out, *c.dc_out, c.in - c.out)) return false;
    c.out = c.in;
    for (int k = 1; k < 64; ++k) {
        const HuffmanTable::Found ac = take(in, *c.ac);
        if (!ac.length) return false;
        const int bits = ac.length + (ac.symbol & 15), zeros = ac.symbol >> 4;
        out.put(in.peek() >> (32 - bits), bits);
        in.skip(bits);
        if ((ac.symbol & 15) == 0 && zeros < 15) break;
        k += zeros;
        if (k > 63) return false;
    }
    return true;
}

}  // namespace

std::optional<DividedScan> divide_scan(std::span<const std::byte> jpeg, const JpegHeader& header,
                                       int interval) {
    Scan scan;
    if (!read_header(jpeg, header, scan)) return std::nullopt;
    DividedScan divided{.tables = choose_codes(scan)};
    BitReader in(jpeg.subspan(header.bytes));
    BitWriter out(jpeg.size() + jpeg.size() / 16);
    const std::int64_t mcus = std::int64_t(header.mcu_columns()) * header.mcu_rows();
    for (std::int64_t mcu = 0; mcu < mcus; ++mcu) {
        if (scan.restart_interval && mcu && mcu % scan.restart_interval == 0) {
            if (in.overrun() || !in.restart()) return std::nullopt;
            for (Component& c : scan.components) c.in = 0;
        }
        out.make_room();
        for (Component& c : scan.components)
            for (int b = 0; b < c.blocks; ++b)
                if (!copy_block(in, out, c)) return std::nullopt;
        if ((mcu + 1) % interval) continue;
        out.finish();
        divided.ends.push_back(out.size());
        for (Component& c : scan.components) c.out = 0;
    }
    if (in.overrun() || !in.at_end()) return std::nullopt;
    divided.bytes = out.take();
    return divided;
}

}  // namespace vantage::codec
