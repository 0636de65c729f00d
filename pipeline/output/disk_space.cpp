#include "pipeline/output/disk_space.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include "base/files/part_file.h"
#include "base/text/error.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// The folder of a file that need not exist.
fs::path folder_of(const fs::path& file) {
    std::error_code error;
    return fs::absolute(file, error).parent_path();
}

std::uint64_t allocated(const fs::path& file) {
    struct stat st {};
    return ::stat(file.c_str(), &st) == 0 ? std::uint64_t(st.st_blocks) * 512 : 0;
}

/// Whether no PackageReader has the file open.
bool unused(const fs::path& file) {
    const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    const bool free = fd >= 0 && ::flock(fd, LOCK_EX | LOCK_NB) == 0;
    if (fd >= 0) ::close(fd);
    return free;
}

bool has_layout(const fs::path& file, const PackageLayout& layout) {
    try {
        return PackageReader(file).header().layout == layout.checksum;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

std::uint64_t disk_space_needed(const PackageLayout& layout) {
    // Compact JPEG photos take a tenth of the raw size, and are stored twice; see docs/measurements.md,
    // "Compact packages".
    return layout.bytes - layout.compact_bytes + layout.compact_bytes / 4;
}

std::uint64_t disk_space_for(const fs::path& out) {
    std::error_code error;
    const fs::space_info space = fs::space(folder_of(out), error);
    if (error) return unknown_space;  // creating the file will report the error
    return space.available + allocated(part_of(out));
}

bool is_in_memory(const fs::path& out) {
    struct statfs at {};
    return ::statfs(folder_of(out).c_str(), &at) == 0 &&
           (at.f_type == TMPFS_MAGIC || at.f_type == RAMFS_MAGIC);
}

void ensure_disk_space(const fs::path& out, const PackageLayout& layout) {
    const std::uint64_t available = disk_space_for(out), needed = disk_space_needed(layout);
    if (available >= needed) return;
    if (!fs::exists(part_of(out)) && has_layout(out, layout) && unused(out)) {
        std::error_code error;
        fs::rename(out, part_of(out), error);
        if (!error) return;
    }
    throw Error(Exit::storage, fmt::format("{}: the package needs {} MB, but the disk has {} MB free",
                                           out.string(), needed / 1000000 + 1, available / 1000000));
}

}  // namespace vantage
