#pragma once
#include <filesystem>
#include <string>

#include "base/files/checksum.h"

namespace vantage {

/// Reads the whole file. Throws Error(input).
FileIdentity identify(const std::filesystem::path& file);

/// Device, inode, length, mtime and ctime: changes whenever the file does; empty if there is no such file.
std::string stamp_of(const std::filesystem::path& file);

/// A file and its stamp, taken before the file is first read.
struct StampedFile {
    std::filesystem::path file;
    std::string stamp{};  ///< empty: unknown
};
StampedFile stamped(const std::filesystem::path& file);
/// Throws Error(input) if the file has been modified since it was stamped, so that different parts of a run
/// may have read different contents.
void expect_unchanged(const StampedFile& file);

}  // namespace vantage
