#include "scene/remote/cache/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include "scene/remote/cache/storage_error.h"

namespace vantage {

MappedFile MappedFile::open(const std::filesystem::path& path, std::uint64_t size, bool writable) {
    MappedFile file;
    file.fd_ = Descriptor(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    struct stat st {};
    if (!file.fd_ || ::fstat(file.descriptor(), &st) != 0) return {};
    if (!S_ISREG(st.st_mode) || std::uint64_t(st.st_size) != size) return {};
    file.size_ = size;
    file.map(path, writable);
    return file;
}

MappedFile MappedFile::create(const std::filesystem::path& path, std::uint64_t size, bool writable,
                              bool reserve) {
    MappedFile file;
    file.fd_ = Descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (!file.fd_) throw storage_error(path, "create");
    if (::ftruncate(file.descriptor(), off_t(size)) != 0) throw storage_error(path, "set the size");
    // If the space were not reserved, writing to a mapped page on a full disk would kill the process.
    if (reserve)
        if (const int error = ::posix_fallocate(file.descriptor(), 0, off_t(size)); error != 0) {
            errno = error;
            throw storage_error(path, "allocate");
        }
    file.size_ = size;
    file.map(path, writable);
    return file;
}

void MappedFile::map(const std::filesystem::path& path, bool writable) {
    void* p = ::mmap(nullptr, size_, PROT_READ | (writable ? PROT_WRITE : 0), MAP_SHARED, descriptor(), 0);
    if (p == MAP_FAILED) throw storage_error(path, "map");
    data_ = static_cast<std::byte*>(p);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : fd_(std::move(other.fd_)), data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    fd_ = std::move(other.fd_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
}

MappedFile::~MappedFile() {
    if (data_) ::munmap(data_, size_);
}

std::uint64_t MappedFile::disk_bytes() const {
    struct stat st {};
    return ::fstat(descriptor(), &st) == 0 ? std::uint64_t(st.st_blocks) * 512 : 0;
}

}  // namespace vantage
