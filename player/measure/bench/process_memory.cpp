#include "player/measure/bench/process_memory.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace vantage {

ProcessMemory process_memory() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t all = 0, resident = 0, of_files = 0;
    statm >> all >> resident >> of_files;
    const auto page = std::uint64_t(::sysconf(_SC_PAGESIZE));
    return {resident * page, (resident - std::min(resident, of_files)) * page};
}

void drop_from_page_cache(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY);
    if (file < 0) return;
    ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    ::close(file);
}

}  // namespace vantage
