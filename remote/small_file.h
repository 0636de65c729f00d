#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// The content of a file of up to 64 KiB; empty if it is missing, a link, larger or unreadable.
std::string read_small_file(const std::filesystem::path& path);

/// Replaces a file at once: readers, also after a crash, see the old content or the new one. Throws
/// Error(storage).
void write_small_file(const std::filesystem::path& path, const std::string& content);

}  // namespace vantage
