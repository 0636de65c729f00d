#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

namespace vantage::fuzz {

/// An in-memory file with a path.
class MemoryFile {
  public:
    MemoryFile() : fd_(::memfd_create("fuzz", MFD_CLOEXEC)) {
        if (fd_ < 0) std::abort();
    }
    ~MemoryFile() { ::close(fd_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(fd_); }
    void set(std::span<const std::uint8_t> bytes) {
        if (::ftruncate(fd_, 0) != 0) std::abort();
        write(0, bytes);
    }
    void write(std::uint64_t at, std::span<const std::uint8_t> bytes) {
        if (::pwrite(fd_, bytes.data(), bytes.size(), off_t(at)) != ssize_t(bytes.size())) std::abort();
    }

  private:
    int fd_;
};

/// An in-memory folder, for inputs that consist of several files.
class MemoryFolder {
  public:
    MemoryFolder() {
        static int folders = 0;
        path_ = "/dev/shm/vantage-fuzz-" + std::to_string(::getpid()) + "-" + std::to_string(folders++);
        std::filesystem::create_directories(path_);
    }
    ~MemoryFolder() { std::filesystem::remove_all(path_); }
    MemoryFolder(const MemoryFolder&) = delete;
    MemoryFolder& operator=(const MemoryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void set(const char* name, std::string_view bytes) const {
        std::ofstream(path_ / name, std::ios::binary | std::ios::trunc)
            .write(bytes.data(), std::streamsize(bytes.size()));
    }

  private:
    std::filesystem::path path_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Splits an input into two files at a line of "----".
inline std::pair<std::string_view, std::string_view> divided(std::string_view all) {
    constexpr std::string_view line = "----\n";
    const std::size_t at = all.find(line);
    if (at == all.npos) return {all, {}};
    return {all.substr(0, at), all.substr(at + line.size())};
}

}  // namespace vantage::fuzz
