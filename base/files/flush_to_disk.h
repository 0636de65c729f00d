#pragma once
#include <filesystem>

namespace vantage {

/// Waits until a file's content, or a folder's list of names, is on the disk. Does nothing if the file system
/// does not support this.
void flush_to_disk(const std::filesystem::path& path);

}  // namespace vantage
