#include "scene/package_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tuple>

#include "scene/checksum.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::DirectoryEntry;
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

}  // namespace

struct PackageWriter::State {
    std::filesystem::path file, part;
    int fd = -1;
    std::uint64_t size = 0;
    std::vector<DirectoryEntry> directory;
    std::map<Key, std::size_t> index;
    std::vector<char> written;
    std::mutex mutex;

    [[noreturn]] void fail(const char* doing) const {
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

    void seal(std::size_t i, std::span<const std::byte> head) {
        const std::uint64_t sum = checksum(head);
        const std::scoped_lock lock(mutex);
        directory[i].checksum = sum;
        written[i] = 1;
    }
};

PackageWriter::PackageWriter(const std::filesystem::path& file, std::span<const ChunkPlan> plan)
    : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.file = file;
    s.part = file;
    s.part += ".part";
    std::uint64_t offset = aligned(sizeof(package::Header) + plan.size() * sizeof(DirectoryEntry));
    for (const ChunkPlan& chunk : plan) {
        s.index[{std::uint32_t(chunk.type), chunk.photo, chunk.level}] = s.directory.size();
        s.directory.push_back(planned_entry(chunk, offset));
        offset += aligned(s.directory.back().length);
    }
    s.size = offset;
    s.written.assign(plan.size(), 0);
    s.fd = ::open(s.part.c_str(), O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC, 0644);
    if (s.fd < 0) s.fail("create");
    // Asking for the room now turns "disk full" at three in the morning into a refusal at once.
    if (const int error = ::posix_fallocate(s.fd, 0, off_t(s.size)); error == ENOSPC || error == EFBIG) {
        errno = error;
        const std::string need = "reserve " + std::to_string(s.size >> 20) + " MiB";
        ::close(s.fd);
        ::unlink(s.part.c_str());
        s.fd = -1;
        s.fail(need.c_str());
    } else if (error != 0 && ::ftruncate(s.fd, off_t(s.size)) != 0) {
        s.fail("size");
    }
}

PackageWriter::~PackageWriter() {
    if (!state_ || state_->fd < 0) return;
    ::close(state_->fd);
    ::unlink(state_->part.c_str());
}

void PackageWriter::write(package::Type type, std::uint32_t photo, std::span<const std::byte> bytes) {
    State& s = *state_;
    const std::size_t i = s.find(type, photo, 0);
    if (bytes.size() != s.directory[i].length) throw std::logic_error("a chunk is not as long as planned");
    s.put(s.directory[i].offset, bytes);
    s.seal(i, bytes);
}

void PackageWriter::write_blocks(package::Type type, std::uint32_t photo, std::uint32_t level,
                                 const std::function<void(std::size_t b, std::span<std::byte> block)>& fill) {
    State& s = *state_;
    const std::size_t i = s.find(type, photo, level);
    const DirectoryEntry e = s.directory[i];
    std::vector<std::uint64_t> head(e.head_length / sizeof(std::uint64_t), 0);
    std::vector<std::byte> block(e.block_length);
    std::uint64_t at = e.offset + e.head_length;
    for (std::size_t b = 0; at < e.offset + e.length; ++b, at += e.block_length) {
        fill(b, block);
        head[b] = checksum(block);
        s.put(at, block);
    }
    s.put(e.offset, bytes_of(head));
    s.seal(i, bytes_of(head));
    s.start_flush(e.offset, e.length);
}

std::uint64_t PackageWriter::size() const { return state_->size; }

void PackageWriter::finish() {
    State& s = *state_;
    for (char done : s.written)
        if (!done) throw std::logic_error("a planned chunk was never written");
    package::Header h{};
    std::memcpy(h.magic, package::magic, sizeof h.magic);
    h.version = package::version;
    h.directory_count = std::uint32_t(s.directory.size());
    h.directory_offset = sizeof h;
    h.file_size = s.size;
    h.directory_checksum = checksum(bytes_of(s.directory));
    h.header_checksum =
        checksum(std::as_bytes(std::span(&h, 1)).first(offsetof(package::Header, header_checksum)));
    s.put(sizeof h, bytes_of(s.directory));
    s.put(0, std::as_bytes(std::span(&h, 1)));
    // It gets its name only when all of it is on the disk.
    if (::fsync(s.fd) != 0) s.fail("flush");
    ::close(s.fd);
    s.fd = -1;
    std::error_code error;
    std::filesystem::rename(s.part, s.file, error);
    if (error) throw Error(Exit::storage, s.file.string() + ": cannot rename: " + error.message());
}

}  // namespace vantage
