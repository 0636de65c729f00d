#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace vantage {

/// The name under which `file` is written until it is complete.
std::filesystem::path part_of(const std::filesystem::path& file);
/// The name of the file into which a part's chunks are packed if they are not yet at their final positions.
std::filesystem::path packing_of(const std::filesystem::path& file);
/// The name to which an existing part is moved if it has another layout.
std::filesystem::path displaced_part_of(const std::filesystem::path& file);

/// A file that is written as part_of(file), or under another name in the same folder, and is renamed when it
/// is complete. Only one process at a time can have the file open; the lock ends with the process, even if it
/// crashes. Offsets and lengths are in bytes. Reading and writing are thread-safe. Functions throw
/// Error(storage) if a system call fails.
class PartFile {
  public:
    /// Creates the part or opens the existing one.
    explicit PartFile(const std::filesystem::path& file);
    PartFile(const std::filesystem::path& file, const std::filesystem::path& part);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    const std::filesystem::path& file() const { return file_; }

    void write(std::uint64_t offset, std::span<const std::byte> bytes) const;
    void write_zeros(std::uint64_t from, std::uint64_t to) const;
    /// Copies from another file inside the kernel, sharing blocks if the file system can. Returns the number
    /// of bytes copied, which may be less than `length`.
    std::uint64_t copy(int from, std::uint64_t from_offset, std::uint64_t offset, std::uint64_t length) const;
    /// Copies the whole length from another part.
    void copy(const PartFile& from, std::uint64_t from_offset, std::uint64_t offset,
              std::uint64_t length) const;
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;
    /// Returns false if reading fails or the file is too short.
    bool try_read(std::uint64_t offset, std::span<std::byte> bytes) const;

    /// Sets the size and allocates the space now, so that a full disk fails the run at once, not hours later.
    void reserve(std::uint64_t bytes) const;
    /// Sets the size only: unwritten ranges take no space if the file system supports holes.
    void resize(std::uint64_t bytes) const;
    /// Zeroes a range, and frees its space if the file system supports holes.
    void punch_hole(std::uint64_t offset, std::uint64_t length) const;
    /// Waits until everything that was written is on the disk.
    void flush() const;
    /// Starts writing a range to the disk without waiting, so that the disk is busy while photos are
    /// prepared.
    void start_flush(std::uint64_t offset, std::uint64_t length) const;

    /// Renames the part to displaced_part_of() and starts an empty one. Does nothing if the part is empty.
    void displace();
    /// Deletes the part.
    void remove() const;
    /// Deletes the part and closes it.
    void discard();
    /// Flushes the file and its name to the disk.
    void flush_with_name() const;
    /// Flushes the part to the disk, then renames it to file(), so that a file with this name is always
    /// complete. Flushes the folder as well, so that a power cut does not undo the renaming, and deletes the
    /// displaced part.
    void publish();
    /// True after publish() or discard().
    bool published() const { return fd_ < 0; }

  private:
    [[noreturn]] void fail(const std::string& doing) const;
    void open();
    void close();

    std::filesystem::path file_, part_;
    int fd_ = -1;
};

}  // namespace vantage
