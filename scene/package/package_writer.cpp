#include "scene/package/package_writer.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>

#include "base/files/checksum.h"
#include "base/files/descriptor.h"
#include "base/files/flush_to_disk.h"
#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "scene/package/contents/zstd_chunk.h"
#include "scene/package/package_directory.h"
#include "scene/package/package_reader.h"

namespace vantage {

using package::aligned;
using package::DirectoryEntry;
using package::Form;
using package::Header;

namespace {

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
Key key_of(const DirectoryEntry& e) { return {e.type, e.photo, e.level}; }

/// The offset of directory entry `i`.
std::uint64_t slot(std::size_t i) { return sizeof(Header) + i * sizeof(DirectoryEntry); }

/// Whether a chunk has the planned lengths or, if it may be compact, is shorter.
bool is_planned(const DirectoryEntry& e, const DirectoryEntry& plan, bool compact) {
    if (e.form != Form::raw) return compact && e.length < plan.length && e.head_length <= e.length;
    return e.length == plan.length && e.head_length == plan.head_length &&
           e.block_length == plan.block_length;
}

/// Whether the file is a package, finished or not, with the same photo chunks at the same positions.
bool can_resume(const Header& h, const PackageLayout& layout, Share share) {
    const auto is = [&](const char(&magic)[8]) { return std::memcmp(h.magic, magic, sizeof magic) == 0; };
    return (is(package::part_magic) || is(package::magic)) && is_valid(h) && h.version == package::version &&
           h.layout == layout.checksum && h.share == share.share && h.shares == share.shares &&
           h.file_size >= layout.bytes && h.directory_count <= layout.directory.size() + 1;
}

enum class Settled : char {
    no,
    present,  ///< written, kept or copied by this run
    skipped
};

}  // namespace

struct PackageWriter::State {
    PartFile file;
    PackageLayout layout;  ///< its directory is updated as chunks are sealed
    std::vector<DirectoryEntry> planned;
    std::vector<bool> compact;  ///< per chunk
    Share share;
    std::map<Key, std::size_t> index;
    std::vector<Settled> settled;  ///< per chunk
    struct Appended {
        package::Type type;
        std::vector<std::byte> bytes;
    };
    std::vector<Appended> appended;
    bool resumed = false, holds_photos = false;
    mutable std::mutex mutex;  ///< guards checksums, `settled` and `holds_photos`

    State(const std::filesystem::path& path, std::span<const ChunkPlan> plan, std::uint64_t names, Share s)
        : file(path),
          layout(package_layout(plan, names)),
          planned(layout.directory),
          share(s),
          settled(plan.size(), Settled::no) {
        for (const ChunkPlan& chunk : plan) compact.push_back(chunk.compact);
        for (std::size_t i = 0; i < layout.directory.size(); ++i) index[key_of(layout.directory[i])] = i;
    }

    std::size_t find(package::Type type, std::uint32_t photo, std::uint32_t level) const {
        const auto it = index.find({std::uint32_t(type), photo, level});
        if (it == index.end()) throw std::logic_error("a chunk was written that was not planned");
        return it->second;
    }

    void settle(std::size_t i, const DirectoryEntry& e, Settled how) {
        const std::scoped_lock lock(mutex);
        layout.directory[i] = e;
        settled[i] = how;
    }

    void pad(const DirectoryEntry& e) const {
        file.write_zeros(e.offset + e.length, e.offset + aligned(e.length));
    }

    void seal(std::size_t i, DirectoryEntry e, std::uint64_t head_checksum) {
        e.checksum = head_checksum;
        settle(i, e, Settled::present);
        if (e.photo != package::scene_wide) {
            const std::scoped_lock lock(mutex);
            holds_photos = true;
        }
        file.write(slot(i), bytes_of_one(e));
    }

    /// Appends a chunk. Returns its entry.
    DirectoryEntry write_behind(const Appended& chunk) {
        DirectoryEntry e{};
        e.type = std::uint32_t(chunk.type);
        e.version = 1;
        e.photo = package::scene_wide;
        e.offset = layout.bytes;
        const std::vector<std::byte> shorter =
            layout.compact() ? zstd_chunk(chunk.bytes) : std::vector<std::byte>{};
        if (!shorter.empty()) e.form = Form::zstd;
        const std::span<const std::byte> bytes = shorter.empty() ? chunk.bytes : shorter;
        e.length = e.head_length = bytes.size();
        e.checksum = checksum(bytes);
        file.write(e.offset, bytes);
        pad(e);
        layout.bytes += aligned(e.length);
        return e;
    }
    bool resume();
    void begin();
    Header final_header(std::span<const DirectoryEntry> present) const;
    void publish_in_place(std::span<const DirectoryEntry> present);
    void publish_together(std::span<DirectoryEntry> present);
};

/// Reuses the chunks that an earlier run sealed. Returns false if the file does not have this layout.
bool PackageWriter::State::resume() {
    Header h{};
    const auto header = std::as_writable_bytes(std::span(&h, 1));
    if (!file.try_read(0, header) || !can_resume(h, layout, share)) return false;
    std::vector<DirectoryEntry> sealed(h.directory_count);
    if (!file.try_read(sizeof h, std::as_writable_bytes(std::span(sealed)))) return false;
    for (const DirectoryEntry& e : sealed) {
        const auto it = index.find(key_of(e));
        if (it != index.end() && e.photo != package::scene_wide && e.offset == planned[it->second].offset &&
            is_planned(e, planned[it->second], compact[it->second]))
            layout.directory[it->second] = e;
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

Header PackageWriter::State::final_header(std::span<const DirectoryEntry> present) const {
    Header h = make_header(share.shares == 0 ? package::magic : package::part_magic, layout, share);
    h.directory_count = std::uint32_t(present.size());
    h.directory_checksum = checksum(std::as_bytes(present));
    return h;
}

void PackageWriter::State::publish_in_place(std::span<const DirectoryEntry> present) {
    Header h = final_header(present);
    seal_header(h);
    file.write(sizeof h, std::as_bytes(present));
    file.write_zeros(slot(present.size()), aligned(slot(planned.size() + 1)));
    file.write(0, bytes_of_one(h));
    file.publish();
}

/// Packs the chunks into another file. The part remains until that file is complete; see
/// publish_interrupted().
void PackageWriter::State::publish_together(std::span<DirectoryEntry> present) {
    PartFile together(file.file(), packing_of(file.file()));
    together.resize(0);
    // The magic is written first, so that the file is recognized as ours even after a power cut.
    together.write(0, std::as_bytes(std::span(package::part_magic)));
    together.flush();
    std::uint64_t at = slot(present.size());
    for (DirectoryEntry& e : present) {
        const std::uint64_t from = e.offset;
        const std::uint64_t unit = e.form == Form::raw ? package::alignment : package::coded_alignment;
        e.offset = (at + unit - 1) / unit * unit;
        together.copy(file, from, e.offset, e.length);
        at = e.offset + e.length;
    }
    together.resize(at);  // in case the last chunk is empty
    layout.bytes = at;
    Header h = final_header(present);
    h.layout = 0;  // no part has its chunks at these positions
    seal_header(h);
    together.write(sizeof h, std::as_bytes(present));
    together.write(0, bytes_of_one(h));
    together.flush_with_name();
    file.discard();
    together.publish();
}

PackageWriter::PackageWriter(const std::filesystem::path& file, std::span<const ChunkPlan> plan,
                             std::uint64_t names, Share share)
    : state_(std::make_unique<State>(file, plan, names, share)) {
    State& s = *state_;
    s.resumed = s.holds_photos = s.resume();
    if (!s.resumed) s.file.displace();
    try {
        // The file is marked before it has a size, so that it is recognized as a part after a crash or a
        // power cut.
        s.file.write(0, std::as_bytes(std::span(package::part_magic)));
        if (!s.resumed) s.file.flush();
        s.layout.compact() ? s.file.resize(s.layout.bytes) : s.file.reserve(s.layout.bytes);
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
    DirectoryEntry e = s.planned[i];
    if (bytes.size() != e.length) throw std::logic_error("a chunk is not as long as planned");
    std::vector<std::byte> shorter;
    if (s.compact[i]) shorter = zstd_chunk(bytes);
    if (!shorter.empty()) {
        e.form = Form::zstd;
        e.length = e.head_length = shorter.size();
        bytes = shorter;
    }
    s.file.write(e.offset, bytes);
    s.pad(e);
    s.seal(i, e, checksum(bytes));
}

void PackageWriter::write_blocks(package::Type type, std::uint32_t photo, std::uint32_t level,
                                 const std::function<void(std::size_t b, std::span<std::byte> block)>& fill) {
    State& s = *state_;
    const std::size_t i = s.find(type, photo, level);
    const DirectoryEntry e = s.planned[i];
    std::vector<std::uint64_t> head(e.head_length / sizeof(std::uint64_t), 0);
    std::vector<std::byte> block(e.block_length);
    std::uint64_t at = e.offset + e.head_length;
    for (std::size_t b = 0; at < e.offset + e.length; ++b, at += e.block_length) {
        fill(b, block);
        head[b] = checksum(block);
        s.file.write(at, block);
    }
    s.file.write(e.offset, bytes_of(head));
    s.seal(i, e, checksum(bytes_of(head)));
    s.file.start_flush(e.offset, e.length);
}

bool PackageWriter::write_coded(package::Type type, std::uint32_t photo, std::uint32_t level,
                                const CodedBlocks& blocks) {
    State& s = *state_;
    const std::size_t i = s.find(type, photo, level), n = blocks.ends.size();
    DirectoryEntry e = s.planned[i];
    if (!s.compact[i]) throw std::logic_error("a chunk to be coded was not planned as compact");
    e.form = blocks.form;
    e.coded_blocks = std::uint32_t(n);
    e.block_length = 0;
    e.head_length = package::coded_block_entry * n + blocks.shared.size();
    e.length = e.head_length + blocks.bytes.size();
    if (e.length >= s.planned[i].length) return false;
    std::vector<std::uint64_t> tables(2 * n);
    for (std::size_t b = 0; b < n; ++b) {
        const std::uint64_t from = b ? blocks.ends[b - 1] : 0;
        tables[b] = checksum(std::span(blocks.bytes).subspan(from, blocks.ends[b] - from));
        tables[n + b] = blocks.ends[b];
    }
    std::vector<std::byte> head(e.head_length);
    std::ranges::copy(bytes_of(tables), head.begin());
    std::ranges::copy(blocks.shared, head.begin() + std::ptrdiff_t(tables.size() * sizeof tables[0]));
    s.file.write(e.offset, head);
    s.file.write(e.offset + e.head_length, blocks.bytes);
    s.seal(i, e, checksum(head));
    s.file.start_flush(e.offset, e.length);
    return true;
}

bool PackageWriter::plans(package::Type type, std::uint32_t photo, std::uint32_t level) const {
    return state_->index.contains({std::uint32_t(type), photo, level});
}

bool PackageWriter::compact(package::Type type, std::uint32_t photo, std::uint32_t level) const {
    return state_->compact[state_->find(type, photo, level)];
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
    s.settle(s.find(package::Type(entry.type), entry.photo, entry.level), entry, Settled::present);
}

void PackageWriter::copy(const PackageReader& from, const DirectoryEntry& entry, std::uint32_t photo) {
    State& s = *state_;
    const std::size_t i = s.find(package::Type(entry.type), photo, entry.level);
    if (!is_planned(entry, s.planned[i], s.compact[i]))
        throw std::logic_error("a chunk to copy is not as long as planned");
    DirectoryEntry e = entry;
    e.photo = photo;
    e.offset = s.planned[i].offset;
    const std::uint64_t copied = s.file.copy(from.descriptor(), entry.offset, e.offset, e.length);
    s.file.write(e.offset + copied, from.raw(entry).subspan(copied));
    s.pad(e);
    s.seal(i, e, entry.checksum);
    s.file.start_flush(e.offset, e.length);
}

void PackageWriter::skip(std::uint32_t photo) {
    State& s = *state_;
    for (std::size_t i = 0; i < s.layout.directory.size(); ++i) {
        const DirectoryEntry& e = s.planned[i];
        if (e.photo != photo) continue;
        s.settle(i, e, Settled::skipped);
        s.file.write(slot(i), bytes_of_one(DirectoryEntry{}));
        s.file.punch_hole(e.offset, aligned(e.length));
    }
}

std::vector<std::byte> PackageWriter::read(package::Type type, std::uint32_t photo) const {
    const State& s = *state_;
    const DirectoryEntry& e = s.layout.directory[s.find(type, photo, 0)];
    std::vector<std::byte> bytes(e.length);
    s.file.read(e.offset, bytes);
    if (e.form == Form::raw) return bytes;
    std::vector<std::byte> content = content_of_zstd(bytes);
    if (content.size() != s.planned[s.find(type, photo, 0)].length)
        throw Error(Exit::storage, s.file.file().string() + ": a chunk that was written cannot be read");
    return content;
}

std::uint64_t PackageWriter::checksum_of(package::Type type, std::uint32_t photo, std::uint32_t level) const {
    const State& s = *state_;
    const std::size_t i = s.find(type, photo, level);
    const std::scoped_lock lock(s.mutex);
    if (s.settled[i] != Settled::present) throw std::logic_error("a planned chunk was never written");
    return s.layout.directory[i].checksum;
}

std::uint64_t PackageWriter::size() const { return state_->layout.bytes; }

void publish_interrupted(const std::filesystem::path& file) {
    const std::filesystem::path packing = packing_of(file);
    const Descriptor fd(::open(packing.c_str(), O_RDONLY | O_CLOEXEC));
    if (!fd || ::flock(fd.get(), LOCK_EX | LOCK_NB) != 0)
        return;  // there is no part, or another process is writing it
    try {
        const PackageReader whole(packing);
    } catch (const Error&) {
        return;
    }
    std::error_code error;
    std::filesystem::remove(part_of(file), error);
    rename_file(packing, file);
    flush_to_disk(file.parent_path());
}

void PackageWriter::finish() {
    State& s = *state_;
    std::vector<DirectoryEntry> present;
    for (std::size_t i = 0; i < s.settled.size(); ++i) {
        if (s.settled[i] == Settled::no) throw std::logic_error("a planned chunk was never written");
        if (s.settled[i] == Settled::present) present.push_back(s.layout.directory[i]);
    }
    for (const State::Appended& chunk : s.appended) present.push_back(s.write_behind(chunk));
    s.layout.compact() ? s.publish_together(present) : s.publish_in_place(present);
}

}  // namespace vantage
