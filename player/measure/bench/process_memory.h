#pragma once
#include <cstdint>
#include <filesystem>

namespace vantage {

/// Memory of this process, bytes.
struct ProcessMemory {
    std::uint64_t resident;
    std::uint64_t anonymous;  ///< resident and not backed by a file
};
ProcessMemory process_memory();

/// Asks the kernel to drop a file from the page cache.
void drop_from_page_cache(const std::filesystem::path& file);

}  // namespace vantage
