#include "scene/package_writer.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tuple>

#include "scene/checksum.h"
#include "scene/error.h"
#include "scene/package_reader.h"

namespace vantage {
namespace {

using package::DirectoryEntry;
using package::Header;
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

std::uint64_t aligned(std::uint64_t n) {
    return (n + package::alignment - 1) / package::alignment * package::alignment;
}

DirectoryEntry planned_entry(const ChunkPlan& plan, std::uint64_t offset) {
    DirectoryEntry e{};
    e.type = std::uint32_t(plan.type);
    e.version = 1;
    e.photo = plan.photo;
    e.level = plan.level;
    e.offset = offset;
    e.head_length = plan.blocks ? aligned(plan.blocks * sizeof(std::uint64_t)) : plan.bytes;
    e.block_length = plan.blocks ? plan.block_length : 0;
    e.length = e.head_length + plan.blocks * e.block_length;
    return e;
}

struct Layout {
    std::vector<DirectoryEntry> directory;  ///< without checksums
    std::uint64_t size = 0;
};

Layout lay_out(std::span<const ChunkPlan> plan) {
    Layout out;
    out.size = aligned(sizeof(Header) + plan.size() * sizeof(DirectoryEntry));
    for (const ChunkPlan& chunk : plan) {
        out.directory.push_back(planned_entry(chunk, out.size));
        out.size += aligned(out.directory.back().length);
    }
    return out;
}

/// Scene-wide chunks are written by every run: where they lie does not matter for what can be kept.
std::uint64_t layout_checksum(const Layout& layout, std::uint64_t names) {
    std::vector<std::uint64_t> words{names, layout.size, layout.directory.size()};
    for (const DirectoryEntry& e : layout.directory) {
        words.push_back(std::uint64_t(e.type) << 32 | e.level);
        if (e.photo == package::scene_wide) continue;
        words.insert(words.end(), {e.photo, e.offset, e.length});
    }
    return checksum(bytes_of(words));
}

Header make_header(const char (&magic)[8], const Layout& layout, std::uint64_t layout_sum, Share share) {
    Header h{};
    std::memcpy(h.magic, magic, sizeof h.magic);
    h.version = package::version;
    h.directory_count = std::uint32_t(layout.directory.size());
    h.directory_offset = sizeof h;
    h.file_size = layout.size;
    h.layout = layout_sum;
    h.share = share.share;
    h.shares = share.shares;
    return h;
}

void seal_header(Header& h) {
    h.header_checksum = checksum(bytes_of_one(h).first(offsetof(Header, header_checksum)));
}

Key key_of(const DirectoryEntry& e) { return {e.type, e.photo, e.level}; }

bool same_place(const DirectoryEntry& a, const DirectoryEntry& b) {
    return a.offset == b.offset && a.length == b.length && a.head_length == b.head_length &&
           a.block_length == b.block_length;
}

}  // namespace

PackageLayout package_layout(std::span<const ChunkPlan> plan, std::uint64_t names) {
    const Layout layout = lay_out(plan);
    return {layout.size, layout_checksum(layout, names)};
}

std::filesystem::path part_of(const std::filesystem::path& file) { return file.string() + ".part"; }
std::filesystem::path former_part_of(const std::filesystem::path& file) { return file.string() + ".former"; }

struct PackageWriter::State {
    std::filesystem::path file, part;
    int fd = -1;
    Layout layout;
    std::uint64_t layout_sum = 0;
    Share share;
    std::map<Key, std::size_t> index;
    std::vector<char> settled;  ///< a chunk: this run wrote, kept, copied or left it out
    bool resumed = false, holds_something = false;
    mutable std::mutex mutex;

    [[noreturn]] void fail(const std::string& doing) const {
        throw Error(Exit::storage, part.string() + ": cannot " + doing + ": " + std::strerror(errno));
    }

    void put(std::uint64_t offset, std::span<const std::byte> bytes) const {
        while (!bytes.empty()) {
            const ssize_t n = ::pwrite(fd, bytes.data(), bytes.size(), off_t(offset));
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) fail("write");
            bytes = bytes.subspan(std::size_t(n));
            offset += std::uint64_t(n);
        }
    }

    void put_zeros(std::uint64_t from, std::uint64_t to) const {
        const std::vector<std::byte> zeros(package::alignment);
        for (; from < to; from += zeros.size())
            put(from, std::span(zeros).first(std::min<std::uint64_t>(zeros.size(), to - from)));
    }

    /// The disk works while the next photo is prepared, instead of all at the end.
    void start_flush([[maybe_unused]] std::uint64_t offset, [[maybe_unused]] std::uint64_t length) const {
#ifdef SYNC_FILE_RANGE_WRITE
        ::sync_file_range(fd, off64_t(offset), off64_t(length), SYNC_FILE_RANGE_WRITE);
#endif
    }

    std::size_t find(package::Type type, std::uint32_t photo, std::uint32_t level) const {
        const auto it = index.find({std::uint32_t(type), photo, level});
        if (it == index.end()) throw std::logic_error("a chunk was written that was not planned");
        return it->second;
    }

    std::uint64_t slot(std::size_t i) const { return sizeof(Header) + i * sizeof(DirectoryEntry); }

    void seal(std::size_t i, std::uint64_t head_checksum) {
        DirectoryEntry& e = layout.directory[i];
        {
            const std::scoped_lock lock(mutex);
            e.checksum = head_checksum;
            settled[i] = 1;
            holds_something = holds_something || e.photo != package::scene_wide;
        }
        put(slot(i), bytes_of_one(e));
    }

    void open();
    bool take_up();
    void move_aside();
    void reserve();
    void begin();
};

/// Only one process at a time: the lock goes with the process, however it ends.
void PackageWriter::State::open() {
    fd = ::open(part.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (fd < 0) fail("create");
    if (::flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(fd);
        fd = -1;
        throw Error(Exit::storage, part.string() + ": another process is writing it");
    }
}

/// Takes what an earlier run sealed in a file of this layout.
bool PackageWriter::State::take_up() {
    Header h{};
    if (::pread(fd, &h, sizeof h, 0) != ssize_t(sizeof h)) return false;
    Header expected = h;
    seal_header(expected);
    const bool part_of_one = std::memcmp(h.magic, package::part_magic, sizeof h.magic) == 0,
               whole = std::memcmp(h.magic, package::magic, sizeof h.magic) == 0;
    if (!(part_of_one || whole) || h.header_checksum != expected.header_checksum ||
        h.version != package::version || h.layout != layout_sum || h.share != share.share ||
        h.shares != share.shares || h.file_size != layout.size || h.directory_count > layout.directory.size())
        return false;
    std::vector<DirectoryEntry> sealed(h.directory_count);
    const auto bytes = ssize_t(sealed.size() * sizeof(DirectoryEntry));
    if (::pread(fd, sealed.data(), std::size_t(bytes), sizeof h) != bytes) return false;
    for (const DirectoryEntry& e : sealed) {
        const auto it = index.find(key_of(e));
        if (it != index.end() && e.photo != package::scene_wide &&
            same_place(e, layout.directory[it->second]))
            layout.directory[it->second].checksum = e.checksum;
    }
    return true;
}

void PackageWriter::State::move_aside() {
    struct stat st {};
    if (::fstat(fd, &st) != 0 || st.st_size == 0) return;
    std::error_code error;
    std::filesystem::rename(part, former_part_of(file), error);
    if (error) throw Error(Exit::storage, part.string() + ": cannot rename: " + error.message());
    ::close(fd);
    open();
}

/// Asking for the room now turns "disk full" at three in the morning into a refusal at once.
void PackageWriter::State::reserve() {
    const int error = ::posix_fallocate(fd, 0, off_t(layout.size));
    if (error == ENOSPC || error == EFBIG || error == EDQUOT) {
        errno = error;
        fail("reserve " + std::to_string((layout.size >> 20) + 1) + " MiB");
    }
    if (error != 0 && ::ftruncate(fd, off_t(layout.size)) != 0) fail("size");
}

/// From here on the file says of itself that it is a part, and of what.
void PackageWriter::State::begin() {
    Header h = make_header(package::part_magic, layout, layout_sum, share);
    seal_header(h);
    std::vector<DirectoryEntry> slots;
    for (const DirectoryEntry& e : layout.directory)
        slots.push_back(e.checksum || e.photo == package::scene_wide ? e : DirectoryEntry{});
    put(0, bytes_of_one(h));
    put(sizeof h, bytes_of(slots));
}

PackageWriter::PackageWriter(const std::filesystem::path& file, std::span<const ChunkPlan> plan,
                             std::uint64_t names, Share share)
    : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.file = file;
    s.part = part_of(file);
    s.layout = lay_out(plan);
    s.layout_sum = layout_checksum(s.layout, names);
    s.share = share;
    for (std::size_t i = 0; i < s.layout.directory.size(); ++i) s.index[key_of(s.layout.directory[i])] = i;
    s.settled.assign(plan.size(), 0);
    s.open();
    s.resumed = s.holds_something = s.take_up();
    if (!s.resumed) s.move_aside();
    try {
        s.reserve();
        s.begin();
    } catch (...) {
        // A constructor that throws runs no destructor.
        ::close(s.fd);
        if (!s.resumed) ::unlink(s.part.c_str());
        throw;
    }
}

PackageWriter::~PackageWriter() {
    if (!state_ || state_->fd < 0) return;
    if (!state_->holds_something) ::unlink(state_->part.c_str());
    ::close(state_->fd);
}

bool PackageWriter::resumed() const { return state_->resumed; }

void PackageWriter::write(package::Type type, std::uint32_t photo, std::span<const std::byte> bytes) {
    State& s = *state_;
    const std::size_t i = s.find(type, photo, 0);
    const DirectoryEntry e = s.layout.directory[i];
    if (bytes.size() != e.length) throw std::logic_error("a chunk is not as long as planned");
    s.put(e.offset, bytes);
    s.put_zeros(e.offset + e.length, e.offset + aligned(e.length));
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
        s.put(at, block);
    }
    s.put(e.offset, bytes_of(head));
    s.seal(i, checksum(bytes_of(head)));
    s.start_flush(e.offset, e.length);
}

void PackageWriter::note(package::Type type, std::size_t index, std::span<const std::byte> record) {
    const State& s = *state_;
    const DirectoryEntry& e = s.layout.directory[s.find(type, package::scene_wide, 0)];
    s.put(e.offset + index * record.size(), record);
}

void PackageWriter::keep(const DirectoryEntry& entry) {
    State& s = *state_;
    const std::size_t i = s.find(package::Type(entry.type), entry.photo, entry.level);
    const std::scoped_lock lock(s.mutex);
    s.layout.directory[i].checksum = entry.checksum;
    s.settled[i] = 1;
}

void PackageWriter::copy(const PackageReader& from, const DirectoryEntry& entry, std::uint32_t photo) {
    State& s = *state_;
    const std::size_t i = s.find(package::Type(entry.type), photo, entry.level);
    const DirectoryEntry e = s.layout.directory[i];
    if (e.length != entry.length || e.head_length != entry.head_length)
        throw std::logic_error("a chunk to copy is not as long as planned");
    // The system copies, or shares the blocks on disks that can.
    auto source = off64_t(entry.offset), target = off64_t(e.offset);
    std::uint64_t left = e.length;
    while (left > 0) {
        const ssize_t n = ::copy_file_range(from.descriptor(), &source, s.fd, &target, left, 0);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        left -= std::uint64_t(n);
    }
    const auto rest = from.raw(entry);
    s.put(e.offset + e.length - left, rest.subspan(rest.size() - left));
    s.put_zeros(e.offset + e.length, e.offset + aligned(e.length));
    s.seal(i, entry.checksum);
    s.start_flush(e.offset, e.length);
}

void PackageWriter::leave_out(std::uint32_t photo) {
    State& s = *state_;
    for (std::size_t i = 0; i < s.layout.directory.size(); ++i) {
        DirectoryEntry& e = s.layout.directory[i];
        if (e.photo != photo) continue;
        {
            const std::scoped_lock lock(s.mutex);
            e.checksum = 0;
            s.settled[i] = 2;
        }
        s.put(s.slot(i), bytes_of_one(DirectoryEntry{}));
        const std::uint64_t length = aligned(e.length);
#ifdef FALLOC_FL_PUNCH_HOLE
        if (::fallocate(s.fd, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, off_t(e.offset), off_t(length)) ==
            0)
            continue;
#endif
        s.put_zeros(e.offset, e.offset + length);
    }
}

std::vector<std::byte> PackageWriter::read(package::Type type, std::uint32_t photo) const {
    const State& s = *state_;
    const DirectoryEntry& e = s.layout.directory[s.find(type, photo, 0)];
    std::vector<std::byte> bytes(e.length);
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t n = ::pread(s.fd, bytes.data() + at, bytes.size() - at, off_t(e.offset + at));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) s.fail("read");
        at += std::size_t(n);
    }
    return bytes;
}

std::uint64_t PackageWriter::checksum_of(package::Type type, std::uint32_t photo, std::uint32_t level) const {
    const State& s = *state_;
    const std::size_t i = s.find(type, photo, level);
    const std::scoped_lock lock(s.mutex);
    return s.layout.directory[i].checksum;
}

std::uint64_t PackageWriter::size() const { return state_->layout.size; }

void PackageWriter::finish() {
    State& s = *state_;
    std::vector<DirectoryEntry> present;
    for (std::size_t i = 0; i < s.settled.size(); ++i) {
        if (!s.settled[i]) throw std::logic_error("a planned chunk was never written");
        if (s.settled[i] == 1) present.push_back(s.layout.directory[i]);
    }
    const bool whole = s.share.shares == 0;
    Header h = make_header(whole ? package::magic : package::part_magic, s.layout, s.layout_sum, s.share);
    h.directory_count = std::uint32_t(present.size());
    h.directory_checksum = checksum(bytes_of(present));
    seal_header(h);
    s.put(sizeof h, bytes_of(present));
    s.put_zeros(s.slot(present.size()), aligned(s.slot(s.settled.size())));
    s.put(0, bytes_of_one(h));
    // It gets its name only when all of it is on the disk.
    if (::fsync(s.fd) != 0) s.fail("flush");
    std::error_code error;
    std::filesystem::rename(s.part, s.file, error);
    if (error) throw Error(Exit::storage, s.file.string() + ": cannot rename: " + error.message());
    ::close(s.fd);
    s.fd = -1;
    std::filesystem::remove(former_part_of(s.file), error);
}

}  // namespace vantage
