#include "scene/package_writer.h"

#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "scene/checksum.h"
#include "scene/package_reader.h"

namespace vantage {

using package::aligned;
using package::DirectoryEntry;
using package::Header;

namespace {

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
Key key_of(const DirectoryEntry& e) { return {e.type, e.photo, e.level}; }

/// Offset of directory entry `i`.
std::uint64_t slot(std::size_t i) { return sizeof(Header) + i * sizeof(DirectoryEntry); }

bool same_place(const DirectoryEntry& a, const DirectoryEntry& b) {
    return a.offset == b.offset && a.length == b.length && a.head_length == b.head_length &&
           a.block_length == b.block_length;
}

Header make_header(const char (&magic)[8], const PackageLayout& layout, Share share) {
    Header h{};
    std::memcpy(h.magic, magic, sizeof h.magic);
    h.version = package::version;
    h.directory_count = std::uint32_t(layout.directory.size());
    h.directory_offset = sizeof h;
    h.file_size = layout.bytes;
    h.layout = layout.checksum;
    h.share = share.share;
    h.shares = share.shares;
    return h;
}

void seal_header(Header& h) {
    h.header_checksum = checksum(bytes_of_one(h).first(offsetof(Header, header_checksum)));
}

bool is_sound(const Header& h) {
    Header expected = h;
    seal_header(expected);
    return h.header_checksum == expected.header_checksum;
}

/// Whether the file is a package, finished or not, with the same photo chunks in the same places.
bool can_resume(const Header& h, const PackageLayout& layout, Share share) {
    const auto is = [&](const char(&magic)[8]) { return std::memcmp(h.magic, magic, sizeof magic) == 0; };
    return (is(package::part_magic) || is(package::magic)) && is_sound(h) && h.version == package::version &&
           h.layout == layout.checksum && h.share == share.share && h.shares == share.shares &&
           h.file_size >= layout.bytes && h.directory_count <= layout.directory.size() + 1;
}

enum class Settled : char {
    no,
    present,  ///< written, kept or copied by this run
    left_out
};

}  // namespace

struct PackageWriter::State {
    PartFile file;
    PackageLayout layout;  ///< its directory gets checksums as chunks are sealed
    Share share;
    std::map<Key, std::size_t> index;
    std::vector<Settled> settled;  ///< per chunk
    struct Appended {
        package::Type type;
        std::vector<std::byte> bytes;
    };
    std::vector<Appended> appended;
    bool resumed = false, holds_photos = false;
    mutable std::mutex mutex;  ///< of the checksums, `settled` and `holds_photos`

    State(const std::filesystem::path& path, std::span<const ChunkPlan> plan, std::uint64_t names, Share s)
        : file(path), layout(package_layout(plan, names)), share(s), settled(plan.size(), Settled::no) {
        for (std::size_t i = 0; i < layout.directory.size(); ++i) index[key_of(layout.directory[i])] = i;
    }

    std::size_t find(package::Type type, std::uint32_t photo, std::uint32_t level) const {
        const auto it = index.find({std::uint32_t(type), photo, level});
        if (it == index.end()) throw std::logic_error("a chunk was written that was not planned");
        return it->second;
    }

    void settle(std::size_t i, std::uint64_t head_checksum, Settled how) {
        const std::scoped_lock lock(mutex);
        layout.directory[i].checksum = head_checksum;
        settled[i] = how;
    }

    void pad(const DirectoryEntry& e) const {
        file.write_zeros(e.offset + e.length, e.offset + aligned(e.length));
    }

    void seal(std::size_t i, std::uint64_t head_checksum) {
        settle(i, head_checksum, Settled::present);
        const DirectoryEntry& e = layout.directory[i];
        if (e.photo != package::scene_wide) {
            const std::scoped_lock lock(mutex);
            holds_photos = true;
        }
        file.write(slot(i), bytes_of_one(e));
    }

    /// Writes a chunk behind the others. Returns its entry.
    DirectoryEntry write_behind(const Appended& chunk) {
        DirectoryEntry e{};
        e.type = std::uint32_t(chunk.type);
        e.version = 1;
        e.photo = package::scene_wide;
        e.offset = layout.bytes;
        e.length = e.head_length = chunk.bytes.size();
        e.checksum = checksum(chunk.bytes);
        file.write(e.offset, chunk.bytes);
        pad(e);
        layout.bytes += aligned(e.length);
        return e;
    }
    bool resume();
    void begin();
};

/// Adopts the chunks that an earlier run sealed; false if the file does not have this layout.
bool PackageWriter::State::resume() {
    Header h{};
    const auto header = std::as_writable_bytes(std::span(&h, 1));
    if (!file.try_read(0, header) || !can_resume(h, layout, share)) return false;
    std::vector<DirectoryEntry> sealed(h.directory_count);
    if (!file.try_read(sizeof h, std::as_writable_bytes(std::span(sealed)))) return false;
    for (const DirectoryEntry& e : sealed) {
        const auto it = index.find(key_of(e));
        if (it != index.end() && e.photo != package::scene_wide &&
            same_place(e, layout.directory[it->second]))
            layout.directory[it->second].checksum = e.checksum;
    }
    return true;
}

/// Marks the file as a part and lists the chunks that it holds.
void PackageWriter::State::begin() {
    Header h = make_header(package::part_magic, layout, share);
    seal_header(h);
    std::vector<DirectoryEntry> slots;
    for (const DirectoryEntry& e : layout.directory)
        slots.push_back(e.checksum || e.photo == package::scene_wide ? e : DirectoryEntry{});
    file.write(0, bytes_of_one(h));
    file.write(sizeof h, bytes_of(slots));
}

PackageWriter::PackageWriter(const std::filesystem::path& file, std::span<const ChunkPlan> plan,
                             std::uint64_t names, Share share)
    : state_(std::make_unique<State>(file, plan, names, share)) {
    State& s = *state_;
    s.resumed = s.holds_photos = s.resume();
    if (!s.resumed) s.file.displace();
    try {
        // Marks the file before it has a size, so that after a crash or a power cut it is recognized as a
        // part.
        s.file.write(0, std::as_bytes(std::span(package::part_magic)));
        if (!s.resumed) s.file.flush();
        s.file.reserve(s.layout.bytes);
        s.begin();
    } catch (...) {
        // The destructor does not run if the constructor throws.
        if (!s.resumed) s.file.remove();
        throw;
    }
}

PackageWriter::~PackageWriter() {
    if (!state_->file.published() && !state_->holds_photos) state_->file.remove();
}

bool PackageWriter::resumed() const { return state_->resumed; }

void PackageWriter::write(package::Type type, std::uint32_t photo, std::span<const std::byte> bytes) {
    State& s = *state_;
    const std::size_t i = s.find(type, photo, 0);
    const DirectoryEntry e = s.layout.directory[i];
    if (bytes.size() != e.length) throw std::logic_error("a chunk is not as long as planned");
    s.file.write(e.offset, bytes);
    s.pad(e);
    s.seal(i, checksum(bytes));
}

void PackageWriter::write_blocks(package::Type type, std::uint32_t photo, std::uint32_t level,
                                 const std::function<void(std::size_t b, std::span<std::byte> block)>& fill) {
    State& s = *state_;
    const std::size_t i = s.find(type, photo, level);
    const DirectoryEntry e = s.layout.directory[i];
    std::vector<std::uint64_t> head(e.head_length / sizeof(std::uint64_t), 0);
    std::vector<std::byte> block(e.block_length);
    std::uint64_t at = e.offset + e.head_length;
    for (std::size_t b = 0; at < e.offset + e.length; ++b, at += e.block_length) {
        fill(b, block);
        head[b] = checksum(block);
        s.file.write(at, block);
    }
    s.file.write(e.offset, bytes_of(head));
    s.seal(i, checksum(bytes_of(head)));
    s.file.start_flush(e.offset, e.length);
}

void PackageWriter::note(package::Type type, std::size_t index, std::span<const std::byte> record) {
    const State& s = *state_;
    const DirectoryEntry& e = s.layout.directory[s.find(type, package::scene_wide, 0)];
    s.file.write(e.offset + index * record.size(), record);
}

void PackageWriter::append(package::Type type, std::span<const std::byte> bytes) {
    state_->appended.push_back({type, {bytes.begin(), bytes.end()}});
}

void PackageWriter::keep(const DirectoryEntry& entry) {
    State& s = *state_;
    s.settle(s.find(package::Type(entry.type), entry.photo, entry.level), entry.checksum, Settled::present);
}

void PackageWriter::copy(const PackageReader& from, const DirectoryEntry& entry, std::uint32_t photo) {
    State& s = *state_;
    const std::size_t i = s.find(package::Type(entry.type), photo, entry.level);
    const DirectoryEntry e = s.layout.directory[i];
    if (e.length != entry.length || e.head_length != entry.head_length)
        throw std::logic_error("a chunk to copy is not as long as planned");
    const std::uint64_t copied = s.file.copy(from.descriptor(), entry.offset, e.offset, e.length);
    s.file.write(e.offset + copied, from.raw(entry).subspan(copied));
    s.pad(e);
    s.seal(i, entry.checksum);
    s.file.start_flush(e.offset, e.length);
}

void PackageWriter::leave_out(std::uint32_t photo) {
    State& s = *state_;
    for (std::size_t i = 0; i < s.layout.directory.size(); ++i) {
        const DirectoryEntry& e = s.layout.directory[i];
        if (e.photo != photo) continue;
        s.settle(i, 0, Settled::left_out);
        s.file.write(slot(i), bytes_of_one(DirectoryEntry{}));
        s.file.punch_hole(e.offset, aligned(e.length));
    }
}

std::vector<std::byte> PackageWriter::read(package::Type type, std::uint32_t photo) const {
    const State& s = *state_;
    const DirectoryEntry& e = s.layout.directory[s.find(type, photo, 0)];
    std::vector<std::byte> bytes(e.length);
    s.file.read(e.offset, bytes);
    return bytes;
}

std::uint64_t PackageWriter::checksum_of(package::Type type, std::uint32_t photo, std::uint32_t level) const {
    const State& s = *state_;
    const std::size_t i = s.find(type, photo, level);
    const std::scoped_lock lock(s.mutex);
    if (s.settled[i] != Settled::present) throw std::logic_error("a planned chunk was never written");
    return s.layout.directory[i].checksum;
}

std::uint64_t PackageWriter::size() const { return state_->layout.bytes; }

void PackageWriter::finish() {
    State& s = *state_;
    std::vector<DirectoryEntry> present;
    for (std::size_t i = 0; i < s.settled.size(); ++i) {
        if (s.settled[i] == Settled::no) throw std::logic_error("a planned chunk was never written");
        if (s.settled[i] == Settled::present) present.push_back(s.layout.directory[i]);
    }
    const bool whole = s.share.shares == 0;
    const std::uint64_t directory_end = slot(s.settled.size() + 1);
    for (const State::Appended& chunk : s.appended) present.push_back(s.write_behind(chunk));
    Header h = make_header(whole ? package::magic : package::part_magic, s.layout, s.share);
    h.directory_count = std::uint32_t(present.size());
    h.directory_checksum = checksum(bytes_of(present));
    seal_header(h);
    s.file.write(sizeof h, bytes_of(present));
    s.file.write_zeros(slot(present.size()), aligned(directory_end));
    s.file.write(0, bytes_of_one(h));
    s.file.publish();
}

}  // namespace vantage
