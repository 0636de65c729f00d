#include "base/files/part_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "base/files/flush_to_disk.h"
#include "base/files/replace_file.h"
#include "base/text/error.h"

namespace vantage {
namespace {

/// Whether the open file is still the one with this name.
bool is_at(int fd, const std::filesystem::path& path) {
    struct stat opened {
    }, named{};
    return ::fstat(fd, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

}  // namespace

std::filesystem::path part_of(const std::filesystem::path& file) { return file.string() + ".part"; }
std::filesystem::path packing_of(const std::filesystem::path& file) { return file.string() + ".packing"; }
std::filesystem::path displaced_part_of(const std::filesystem::path& file) {
    return file.string() + ".former";
}

PartFile::PartFile(const std::filesystem::path& file) : PartFile(file, part_of(file)) {}
PartFile::PartFile(const std::filesystem::path& file, const std::filesystem::path& part)
    : file_(file), part_(part) {
    open();
}

PartFile::~PartFile() { close(); }

void PartFile::fail(const std::string& doing) const {
    throw Error(Exit::storage, part_.string() + ": cannot " + doing + ": " + std::strerror(errno));
}

void PartFile::open() {
    do {
        close();
        fd_ = ::open(part_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
        if (fd_ < 0) fail("create");
        if (::flock(fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            close();
            throw Error(Exit::storage, part_.string() + ": another process is writing it");
        }
        // Another process may have completed or removed the file between opening and locking.
    } while (!is_at(fd_, part_));
}

void PartFile::close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
}

void PartFile::write(std::uint64_t offset, std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t n = ::pwrite(fd_, bytes.data(), bytes.size(), off_t(offset));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) fail("write");
        bytes = bytes.subspan(std::size_t(n));
        offset += std::uint64_t(n);
    }
}

void PartFile::write_zeros(std::uint64_t from, std::uint64_t to) const {
    const std::vector<std::byte> zeros(4096);
    for (; from < to; from += zeros.size())
        write(from, std::span(zeros).first(std::min<std::uint64_t>(zeros.size(), to - from)));
}

std::uint64_t PartFile::copy(int from, std::uint64_t from_offset, std::uint64_t offset,
                             std::uint64_t length) const {
    auto source = off64_t(from_offset), target = off64_t(offset);
    std::uint64_t copied = 0;
    while (copied < length) {
        const ssize_t n = ::copy_file_range(from, &source, fd_, &target, length - copied, 0);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        copied += std::uint64_t(n);
    }
    return copied;
}

void PartFile::copy(const PartFile& from, std::uint64_t from_offset, std::uint64_t offset,
                    std::uint64_t length) const {
    std::uint64_t done = copy(from.fd_, from_offset, offset, length);
    std::vector<std::byte> bytes;
    while (done < length) {
        bytes.resize(std::min<std::uint64_t>(length - done, 1 << 20));
        from.read(from_offset + done, bytes);
        write(offset + done, bytes);
        done += bytes.size();
    }
}

void PartFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    if (!try_read(offset, bytes)) fail("read");
}

bool PartFile::try_read(std::uint64_t offset, std::span<std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t n = ::pread(fd_, bytes.data(), bytes.size(), off_t(offset));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        bytes = bytes.subspan(std::size_t(n));
        offset += std::uint64_t(n);
    }
    return true;
}

void PartFile::reserve(std::uint64_t bytes) const {
    const int error = ::posix_fallocate(fd_, 0, off_t(bytes));
    if (error == ENOSPC || error == EFBIG || error == EDQUOT) {
        errno = error;
        fail("reserve " + std::to_string((bytes >> 20) + 1) + " MiB");
    }
    // An existing part may be longer than `bytes`, because an interrupted run appended to it.
    struct stat st {};
    const bool longer = ::fstat(fd_, &st) == 0 && std::uint64_t(st.st_size) > bytes;
    if (error != 0 || longer) resize(bytes);
}

void PartFile::resize(std::uint64_t bytes) const {
    if (::ftruncate(fd_, off_t(bytes)) != 0) fail("size");
}

void PartFile::punch_hole(std::uint64_t offset, std::uint64_t length) const {
#ifdef FALLOC_FL_PUNCH_HOLE
    if (::fallocate(fd_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, off_t(offset), off_t(length)) == 0)
        return;
#endif
    write_zeros(offset, offset + length);
}

void PartFile::start_flush([[maybe_unused]] std::uint64_t offset,
                           [[maybe_unused]] std::uint64_t length) const {
#ifdef SYNC_FILE_RANGE_WRITE
    ::sync_file_range(fd_, off64_t(offset), off64_t(length), SYNC_FILE_RANGE_WRITE);
#endif
}

void PartFile::displace() {
    struct stat st {};
    if (::fstat(fd_, &st) != 0 || st.st_size == 0) return;
    rename_file(part_, displaced_part_of(file_));
    close();
    open();
}

void PartFile::remove() const { ::unlink(part_.c_str()); }

void PartFile::discard() {
    remove();
    close();
}

void PartFile::flush() const {
    if (::fsync(fd_) != 0) fail("flush");
}

void PartFile::flush_with_name() const {
    flush();
    flush_to_disk(part_.parent_path());
}

void PartFile::publish() {
    flush();
    rename_file(part_, file_);
    flush_to_disk(file_.parent_path());
    close();
    std::error_code ignored;
    std::filesystem::remove(displaced_part_of(file_), ignored);
}

}  // namespace vantage
