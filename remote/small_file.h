#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// The first 64 KiB of a file; empty if it is missing, a link or unreadable.
std::string read_small_file(const std::filesystem::path& path);

/// Replaces a file at once: readers, also after a crash, see the old content or the new one. A crash may
/// leave a file with the same name and `.part`. Throws Error(storage).
void write_small_file(const std::filesystem::path& path, const std::string& content);

}  // namespace vantage
