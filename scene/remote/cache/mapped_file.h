#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "base/files/descriptor.h"

namespace vantage {

/// An open file, mapped as a whole and shared with other processes.
class MappedFile {
  public:
    /// Opens a file of exactly `size` bytes; the result is empty if there is no such file. Links are not
    /// followed. Throws Error(storage).
    static MappedFile open(const std::filesystem::path& path, std::uint64_t size, bool writable);
    /// Creates a file of zeros. The file has no blocks on the disk unless `reserve` is set. Throws
    /// Error(storage) if the file exists or the disk is full.
    static MappedFile create(const std::filesystem::path& path, std::uint64_t size, bool writable,
                             bool reserve);
    MappedFile() = default;
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    ~MappedFile();

    explicit operator bool() const { return data_ != nullptr; }
    std::byte* data() const { return data_; }
    std::uint64_t size() const { return size_; }
    int descriptor() const { return fd_.get(); }
    /// The number of bytes that the file uses on the disk.
    std::uint64_t disk_bytes() const;

  private:
    void map(const std::filesystem::path& path, bool writable);

    Descriptor fd_;
    std::byte* data_ = nullptr;
    std::uint64_t size_ = 0;
};

}  // namespace vantage
