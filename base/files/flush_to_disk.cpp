#include "base/files/flush_to_disk.h"

#include <fcntl.h>
#include <unistd.h>

namespace vantage {

void flush_to_disk(const std::filesystem::path& path) {
    const int fd = ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) return;
    ::fsync(fd);
    ::close(fd);
}

}  // namespace vantage
